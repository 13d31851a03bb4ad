/* A user material whose library lacks a utility routine of Abaqus that it calls. */
void sinv_(double* stress, double* sinv1, double* sinv2, int* ndi, int* nshr);

void umat_(double* stress, double* statev)
{
  int ndi = 3, nshr = 1;
  sinv_(stress, statev, statev + 1, &ndi, &nshr);
}
