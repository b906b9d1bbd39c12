package sunbeam.app.files.input;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/** Reader of a PNG's text chunks (ISO/IEC 15948, 11.3.4), tEXt and uncompressed iTXt, in which Sunbeam's pictures have their parameters. */
public final class PngText {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    private static final int LONGEST_TEXT_BYTES = 1 << 20;

    /** Keyword of the parameters' hash. */
    public static final String PARAMETERS = "Parameters";

    private PngText() {}

    /** Returns the texts of a picture with this hash; empty if the file is missing, damaged or another. */
    public static Optional<Map<String, String>> find(Path file, String hash) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            return Optional.of(read(file)).filter(text -> hash.equals(text.get(PARAMETERS)));
        } catch (InputException unreadable) {
            // The caller decides whether to replace the file.
            return Optional.empty();
        }
    }

    /** Returns the texts by keyword. Throws InputException for no PNG, any damage, a compressed text or one above 1 MiB. */
    public static Map<String, String> read(Path file) {
        InputException.requireRegular(file);
        return InputException.naming(file, () -> {
            try (InputStream stream = Files.newInputStream(file)) {
                return read(new DataInputStream(new BufferedInputStream(stream)));
            }
        });
    }

    private static Map<String, String> read(DataInputStream stream) throws IOException {
        InputException.refuseIf(!Arrays.equals(stream.readNBytes(SIGNATURE.length), SIGNATURE), "it is no PNG file");
        Map<String, String> text = new LinkedHashMap<>();
        CRC32 checksum = new CRC32();
        InputStream checked = new CheckedInputStream(stream, checksum);
        while (true) {
            long length = Integer.toUnsignedLong(stream.readInt());
            checksum.reset();
            String type = new String(checked.readNBytes(4), StandardCharsets.ISO_8859_1);
            if (type.equals("IEND")) {
                return text;
            }
            boolean isText = type.equals("tEXt") || type.equals("iTXt");
            InputException.refuseIf(isText && length > LONGEST_TEXT_BYTES, "a text has " + length + " bytes");
            byte[] data = checked.readNBytes(isText ? (int) length : 0);
            // Pixels are checked too: the texts do not describe a damaged picture.
            checked.skipNBytes(length - data.length);
            InputException.refuseIf(
                    (int) checksum.getValue() != stream.readInt(),
                    "it is damaged (checksum of " + (isText ? "its text" : Text.oneLine(type)) + ")");
            if (isText) {
                addEntry(text, type, data);
            }
        }
    }

    private static void addEntry(Map<String, String> text, String type, byte[] data) {
        String latin = new String(data, StandardCharsets.ISO_8859_1);
        int keywordEnd = end(latin, 0);
        String keyword = latin.substring(0, keywordEnd);
        if (type.equals("tEXt")) {
            text.put(keyword, latin.substring(keywordEnd + 1));
            return;
        }
        // iTXt: keyword, 0, compression flag, compression method, language, 0, translated keyword, 0, text.
        InputException.refuseIf(
                keywordEnd + 1 >= data.length || data[keywordEnd + 1] != 0, "the text '" + keyword + "' is compressed");
        int start = end(latin, end(latin, keywordEnd + 3) + 1) + 1;
        text.put(keyword, new String(data, start, data.length - start, StandardCharsets.UTF_8));
    }

    private static int end(String text, int from) {
        int end = text.indexOf(0, from);
        InputException.refuseIf(end < 0, "its text has no end of a keyword");
        return end;
    }
}
