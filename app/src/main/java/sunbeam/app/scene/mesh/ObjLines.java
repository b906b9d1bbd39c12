package sunbeam.app.scene.mesh;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Path;
import java.util.StringTokenizer;
import sunbeam.precompute.text.Quoted;

/**
 * The lines of an OBJ file as the library needs them: checked one by one, so that a message can name the line; without
 * comments, continuations and tabs; and without all that is no geometry (groups, materials, lines, curves), which becomes
 * empty.
 */
final class ObjLines extends BufferedReader {
    // Coordinates beyond this leave float32's range when areas are squared; no surface is a million kilometres wide.
    private static final double FARTHEST = 1e9;
    private static final String UTF8_MARK = "\u00EF\u00BB\u00BF";
    private static final int MOST_DIGITS = 9;
    private static final int NO_CORNER = -1;

    private final Path file;
    private final ObjLimits limits;
    private long lineNumber;
    private long nextLine = 1;

    ObjLines(Path file, Reader reader, ObjLimits limits) {
        super(reader);
        this.file = file;
        this.limits = limits;
    }

    /** Where the line that was read last begins: file and line, for messages. */
    String place() {
        return file + ", line " + lineNumber;
    }

    @Override
    public String readLine() throws IOException {
        lineNumber = nextLine;
        String line = rawLine();
        if (line == null) {
            return null;
        }
        if (lineNumber == 1 && line.startsWith(UTF8_MARK)) {
            line = line.substring(UTF8_MARK.length());
        }
        return geometry(line);
    }

    /** One line with its continuations; null at the end. */
    private String rawLine() throws IOException {
        StringBuilder line = new StringBuilder();
        boolean any = false;
        for (int character = read(); character >= 0; character = read()) {
            any = true;
            if (character == '\n') {
                nextLine++;
                int last = line.length() - 1;
                if (last < 0 || line.charAt(last) != '\\') {
                    return line.toString();
                }
                line.setCharAt(last, ' ');
            } else if (character != '\r' && line.length() < limits.lineLength()) {
                line.append((char) character);
            } else if (character != '\r') {
                throw new MeshException(
                        place() + " is longer than " + limits.lineLength() + " characters; this is no OBJ text file");
            }
        }
        return any ? line.toString() : null;
    }

    private String geometry(String line) {
        int comment = line.indexOf('#');
        StringTokenizer words = new StringTokenizer(comment < 0 ? line : line.substring(0, comment));
        if (!words.hasMoreTokens()) {
            return "";
        }
        String kind = words.nextToken();
        return switch (kind) {
            case "v" -> "v " + numbers(words, "position", 3);
            case "vn" -> "vn " + numbers(words, "normal", 3);
            // One coordinate is a texture along a line; it gets a second one of 0.
            case "vt" ->
                "vt "
                        + (words.countTokens() == 1
                                ? numbers(words, "", 1) + " 0"
                                : numbers(words, "texture coordinate", 2));
            case "f" -> "f " + corners(words);
            default -> "";
        };
    }

    /** The first numbers of the line; further ones (weights, colors, a third texture coordinate) are not used. */
    private String numbers(StringTokenizer words, String what, int count) {
        if (words.countTokens() < count) {
            throw new MeshException(
                    place() + ": a " + what + " needs " + count + " numbers, not " + words.countTokens());
        }
        StringBuilder result = new StringBuilder();
        for (int i = 0; i < count; i++) {
            String word = words.nextToken();
            result.append(i == 0 ? "" : " ").append(requireNumber(word));
        }
        return result.toString();
    }

    private String requireNumber(String word) {
        double value;
        try {
            value = Double.parseDouble(word);
        } catch (NumberFormatException failure) {
            throw new MeshException(place() + ": " + Quoted.of(word) + " is no number; export the mesh again", failure);
        }
        if (!(Math.abs(value) <= FARTHEST)) {
            throw new MeshException(place() + ": " + Quoted.of(word) + " is no finite number up to 1e9;"
                    + " repair the mesh or export it again");
        }
        return word;
    }

    /** Corners of one face; all alike, since the library mixes up faces whose corners differ in kind. */
    private String corners(StringTokenizer words) {
        StringBuilder result = new StringBuilder();
        int kind = -1;
        while (words.hasMoreTokens()) {
            String word = words.nextToken();
            int its = kind(word);
            if (its == NO_CORNER) {
                throw new MeshException(place() + ": " + Quoted.of(word)
                        + " is no corner of a face; write v, v/vt, v//vn or v/vt/vn with whole numbers");
            }
            if (kind >= 0 && kind != its) {
                throw new MeshException(place() + ": the face's corners differ in kind (" + Quoted.of(word)
                        + "); give all of them texture coordinate and normal, or none");
            }
            kind = its;
            result.append(result.isEmpty() ? "" : " ").append(word);
        }
        return result.toString();
    }

    /**
     * 0 to 3 for v, v/vt, v//vn and v/vt/vn, else {@link #NO_CORNER}. By hand: with a regular expression it was a seventh of
     * the time that a mesh took.
     */
    private static int kind(String word) {
        int length = word.length();
        int first = word.indexOf('/');
        int second = first < 0 ? -1 : word.indexOf('/', first + 1);
        if (!isIndex(word, 0, first < 0 ? length : first)) {
            return NO_CORNER;
        }
        if (first < 0) {
            return 0;
        }
        if (second < 0) {
            return isIndex(word, first + 1, length) ? 1 : NO_CORNER;
        }
        if (!isIndex(word, second + 1, length)) {
            return NO_CORNER;
        }
        if (second == first + 1) {
            return 2;
        }
        return isIndex(word, first + 1, second) ? 3 : NO_CORNER;
    }

    /** A whole number of at most nine digits that does not begin with 0, perhaps with a minus sign. */
    private static boolean isIndex(String word, int from, int to) {
        int start = from < to && word.charAt(from) == '-' ? from + 1 : from;
        if (start >= to || to - start > MOST_DIGITS || word.charAt(start) == '0') {
            return false;
        }
        for (int at = start; at < to; at++) {
            if (word.charAt(at) < '0' || word.charAt(at) > '9') {
                return false;
            }
        }
        return true;
    }
}
