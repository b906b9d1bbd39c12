package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.ScanException;

/**
 * Where the numbers of a text begin, and how they are written.
 *
 * @param header the lines before, without their ends
 * @param offset of the first line of numbers, bytes
 * @param decimalComma whether 1,5 is one and a half
 */
record TextHead(List<String> header, long offset, boolean decimalComma) {
    private static final int LONGEST_HEADER = 1 << 18;
    private static final Pattern NUMBER =
            Pattern.compile("[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d{1,3})?|[+-]?[nN][aA][nN]");
    private static final Pattern COMMA_NUMBER =
            Pattern.compile("[+-]?(?:\\d+,?\\d*|,\\d+)(?:[eE][+-]?\\d{1,3})?|[+-]?[nN][aA][nN]");
    private static final Pattern BLANKS = Pattern.compile("[ \\t;\"\\f]+");
    private static final Pattern BLANKS_AND_COMMAS = Pattern.compile("[ \\t;,\"\\f]+");

    /** Nothing when the file is no text, or has no line of numbers after at most 256 KB of header. */
    static Optional<TextHead> of(TextBytes file) throws IOException {
        byte[] head = file.head(LONGEST_HEADER);
        if (!isText(head)) {
            return Optional.empty();
        }
        List<String> header = new ArrayList<>();
        int start = startsWithMark(head) ? 3 : 0;
        while (start < head.length) {
            int end = endOfLine(head, start);
            // The head may cut a line of numbers short, within a number.
            boolean cut = end == head.length && head.length < file.size();
            String line = decode(head, start, end);
            String whole = cut ? line.substring(0, Math.max(0, lastBlank(line))) : line;
            if (areNumbers(whole)) {
                return Optional.of(new TextHead(header, start, hasDecimalCommas(head, start)));
            }
            header.add(line);
            start = nextLine(head, end);
        }
        return Optional.empty();
    }

    private static boolean isText(byte[] head) {
        for (byte b : head) {
            boolean blank = b == '\t' || b == '\n' || b == '\r' || b == '\f';
            if (b >= 0 && b < ' ' && !blank) {
                return false;
            }
        }
        return head.length > 0;
    }

    private static boolean startsWithMark(byte[] head) {
        return head.length >= 3 && head[0] == (byte) 0xef && head[1] == (byte) 0xbb && head[2] == (byte) 0xbf;
    }

    private static int endOfLine(byte[] head, int start) {
        int end = start;
        while (end < head.length && head[end] != '\n' && head[end] != '\r') {
            end++;
        }
        return end;
    }

    private static int nextLine(byte[] head, int end) {
        boolean windows = end + 1 < head.length && head[end] == '\r' && head[end + 1] == '\n';
        return end + (windows ? 2 : 1);
    }

    private static int lastBlank(String line) {
        return Math.max(Math.max(line.lastIndexOf(' '), line.lastIndexOf('\t')), line.lastIndexOf(';'));
    }

    /** UTF-8 where it is, else Latin-1: instruments on Windows still write the latter. */
    private static String decode(byte[] head, int start, int end) {
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(head, start, end - start))
                    .toString();
        } catch (CharacterCodingException latin) {
            return new String(head, start, end - start, StandardCharsets.ISO_8859_1);
        }
    }

    /** Whether a line holds nothing but numbers, at least one. */
    private static boolean areNumbers(String line) {
        return all(line, BLANKS_AND_COMMAS, NUMBER) || all(line, BLANKS, COMMA_NUMBER);
    }

    /**
     * Whether commas are decimal marks, from the first numbers: 1,5 2,5 and 1,5;2,5 and 1,5, 2,5 have decimal commas; 1,2,3 and
     * 1, 2, 3 and 1.5,2.5 have separators.
     *
     * @throws ScanException where they may be either
     */
    private static boolean hasDecimalCommas(byte[] head, int start) {
        boolean withinNumber = false;
        boolean separated = false;
        boolean beforeBlank = false;
        boolean beforeSign = false;
        // A second comma in what would be one number.
        boolean twice = false;
        boolean open = false;
        for (int i = start; i < head.length; i++) {
            byte c = head[i];
            if (c == '.') {
                return false;
            }
            byte next = i + 1 < head.length ? head[i + 1] : (byte) '\n';
            boolean amidLine = next != '\n' && next != '\r';
            if (c == ',' && next >= '0' && next <= '9') {
                twice |= open;
                open = true;
                withinNumber = true;
            } else if (c == ',') {
                boolean blank = next == ' ' || next == '\t' || !amidLine;
                beforeBlank |= blank;
                beforeSign |= !blank;
                open = false;
            } else if (c == ' ' || c == '\t' || c == ';' || c == '\n' || c == '\r') {
                open = false;
            }
            separated |= c == ';' || ((c == ' ' || c == '\t') && amidLine);
        }
        if ((withinNumber || beforeSign) && !beforeBlank && !separated) {
            CommaHalves.refuse(head, start);
        }
        return withinNumber && separated && !beforeSign && !(beforeBlank && twice);
    }

    private static boolean all(String line, Pattern separator, Pattern number) {
        boolean some = false;
        for (String word : separator.splitAsStream(line.strip()).toList()) {
            if (!word.isEmpty()) {
                if (!number.matcher(word).matches()) {
                    return false;
                }
                some = true;
            }
        }
        return some;
    }
}
