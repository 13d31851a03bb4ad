// The text decides, not the release of the file: if all of it is UTF-8, it stays, whatever code page the header names.
// Otherwise each byte above 0x7F is looked up by itself. So only code pages of one byte per letter can stand in the
// table. Escapes \U+XXXX are replaced in both cases.

#include "import/drawing/dxf_letters.hpp"

#include "math/utf8.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace terp {
namespace {

/// Letters of the bytes 0x80 to 0xFF, as Unicode has them (tables of the Unicode consortium). U+FFFD: the byte is no
/// letter.
struct CodePage {
  std::string_view name;  ///< as $DWGCODEPAGE has it, in capitals and without _
  std::u16string_view letters;
};

constexpr std::array pages{CodePage{"ANSI1250",
                               u"€\uFFFD‚\uFFFD„…†‡\uFFFD‰Š‹ŚŤŽŹ\uFFFD‘’“”•–—\uFFFD™š›śťž"
                               u"ź\u00A0ˇ˘Ł¤Ą¦§¨©Ş«¬\u00AD®Ż°±˛ł´µ¶·¸ąş»Ľ˝ľżŔÁÂĂÄĹĆÇČÉĘËĚ"
                               u"ÍÎĎĐŃŇÓÔŐÖ×ŘŮÚŰÜÝŢßŕáâăäĺćçčéęëěíîďđńňóôőö÷řůúűüýţ"
                               u"˙"},
    CodePage{"ANSI1251",
        u"ЂЃ‚ѓ„…†‡€‰Љ‹ЊЌЋЏђ‘’“”•–—\uFFFD™љ›њќћџ\u00A0ЎўЈ¤"
        u"Ґ¦§Ё©Є«¬\u00AD®Ї°±Ііґµ¶·ё№є»јЅѕїАБВГДЕЖЗИЙКЛМНОПРСТУ"
        u"ФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмнопрстуфхцчшщъыьэюя"},
    CodePage{"ANSI1252",
        u"€\uFFFD‚ƒ„…†‡ˆ‰Š‹Œ\uFFFDŽ\uFFFD\uFFFD‘’“”•–—˜™š›œ\uFFFDž"
        u"Ÿ\u00A0¡¢£¤¥¦§¨©ª«¬\u00AD®¯°±²³´µ¶·¸¹º»¼½¾¿ÀÁÂÃÄÅÆÇÈÉÊËÌ"
        u"ÍÎÏÐÑÒÓÔÕÖ×ØÙÚÛÜÝÞßàáâãäåæçèéêëìíîïðñòóôõö÷øùúûüýþ"
        u"ÿ"},
    CodePage{"ANSI1253",
        u"€\uFFFD‚ƒ„…†‡\uFFFD‰\uFFFD‹\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD‘’“”•–—"
        u"\uFFFD™\uFFFD›\uFFFD\uFFFD\uFFFD\uFFFD\u00A0΅Ά£¤¥¦§¨©\uFFFD«¬\u00AD®―°±²³΄µ"
        u"¶·ΈΉΊ»Ό½ΎΏΐΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡ\uFFFDΣΤΥΦΧΨΩΪΫάέήίΰαβγδε"
        u"ζηθικλμνξοπρςστυφχψωϊϋόύώ\uFFFD"},
    CodePage{"ANSI1254",
        u"€\uFFFD‚ƒ„…†‡ˆ‰Š‹Œ\uFFFD\uFFFD\uFFFD\uFFFD‘’“”•–—˜™š›œ"
        u"\uFFFD\uFFFDŸ\u00A0¡¢£¤¥¦§¨©ª«¬\u00AD®¯°±²³´µ¶·¸¹º»¼½¾¿ÀÁÂÃÄÅÆ"
        u"ÇÈÉÊËÌÍÎÏĞÑÒÓÔÕÖ×ØÙÚÛÜİŞßàáâãäåæçèéêëìíîïğñòóôõö÷ø"
        u"ùúûüışÿ"},
    CodePage{"ANSI1257",
        u"€\uFFFD‚\uFFFD„…†‡\uFFFD‰\uFFFD‹\uFFFD¨ˇ¸\uFFFD‘’“”•–—\uFFFD™"
        u"\uFFFD›\uFFFD¯˛\uFFFD\u00A0\uFFFD¢£¤\uFFFD¦§Ø©Ŗ«¬\u00AD®Æ°±²³´µ¶·ø¹ŗ»¼"
        u"½¾æĄĮĀĆÄÅĘĒČÉŹĖĢĶĪĻŠŃŅÓŌÕÖ×ŲŁŚŪÜŻŽßąįāćäåęēčéźėģķī"
        u"ļšńņóōõö÷ųłśūüżž˙"},
    CodePage{"DOS437",
        u"ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»"
        u"░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨"
        u"╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷"
        u"≈°∙·√ⁿ²■\u00A0"},
    CodePage{"DOS850",
        u"ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜø£Ø×ƒáíóúñÑªº¿®¬½¼¡«»░"
        u"▒▓│┤ÁÂÀ©╣║╗╝¢¥┐└┴┬├─┼ãÃ╚╔╩╦╠═╬¤ðÐÊËÈıÍÎ"
        u"Ï┘┌█▄¦Ì▀ÓßÔÒõÕµþÞÚÛÙýÝ¯´\u00AD±‗¾¶§÷¸°¨·¹³²■\u00A0"}};

static_assert(std::ranges::all_of(pages, [](const CodePage& page) { return page.letters.size() == 128; }));

/// The number of \U+XXXX at the start of a text; 0: none is there.
unsigned escaped_number(std::string_view text)
{
  unsigned number = 0;
  if (text.size() < 7 || !text.starts_with("\\U+")) return 0;
  const auto [end, error] = std::from_chars(text.data() + 3, text.data() + 7, number, 16);
  const bool is_half_of_pair = number >= 0xD800 && number < 0xE000;
  return error == std::errc() && end == text.data() + 7 && !is_half_of_pair ? number : 0;
}

}  // namespace

std::u16string_view letters_of_code_page(std::string_view name)
{
  std::string key;
  for (const char c : name)
    if (c != '_') key += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const auto found = std::ranges::find(pages, key, &CodePage::name);
  return found == pages.end() ? std::u16string_view() : found->letters;
}

std::string dxf_letters(std::string_view text, std::string_view code_page)
{
  const std::u16string_view page = letters_of_code_page(code_page.empty() ? "ANSI_1252" : code_page);
  const bool is_sound = as_utf8(text) == text;
  std::string letters;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (const unsigned number = escaped_number(text.substr(k)); number != 0) {
      letters += utf8_of(number);
      k += 6;
    } else if (byte < 0x80 || is_sound) {
      letters += text[k];
    } else {
      letters += utf8_of(page.empty() ? 0xFFFD : page[byte - 0x80]);
    }
  }
  return letters;
}

}  // namespace terp
