package sunbeam.app.scene.mesh;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.StringTokenizer;
import java.util.regex.Pattern;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/** Reader of an OBJ file's positions, normals, texture coordinates and faces; all else is ignored. */
final class ObjFile {
    private static final int LONGEST_LINE = 1 << 16;
    private static final String UTF8_MARK = "\u00EF\u00BB\u00BF";
    private static final Pattern INDEX = Pattern.compile("-?[1-9]\\d{0,8}");

    private final BufferedReader reader;
    private final RawMesh.Builder mesh = new RawMesh.Builder();
    private long line;
    private long nextLine = 1;

    private ObjFile(BufferedReader reader) {
        this.reader = reader;
    }

    static RawMesh read(Path file) throws IOException {
        // No byte is invalid Latin-1, so that names in any encoding can be skipped.
        try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.ISO_8859_1)) {
            return new ObjFile(reader).mesh();
        }
    }

    private RawMesh mesh() throws IOException {
        try {
            for (String text = readLine(); text != null; text = readLine()) {
                int comment = text.indexOf('#');
                StringTokenizer words = new StringTokenizer(comment < 0 ? text : text.substring(0, comment));
                switch (words.hasMoreTokens() ? words.nextToken() : "") {
                    case "v" -> mesh.addPosition(numbers(words, "position", 3));
                    case "vn" -> mesh.addNormal(numbers(words, "normal", 3));
                    case "vt" -> mesh.addTextureCoordinate(numbers(words, "texture coordinate", 2));
                    case "f" -> face(words);
                    default -> {
                        // No geometry.
                    }
                }
            }
        } catch (InputException wrong) {
            throw new InputException("line " + line + ": " + wrong.getMessage(), wrong);
        }
        return mesh.build();
    }

    /** Reads a line with continuations; null at the end. */
    private String readLine() throws IOException {
        line = nextLine;
        StringBuilder text = new StringBuilder();
        boolean any = false;
        for (int character = reader.read(); character >= 0; character = reader.read()) {
            any = true;
            if (character == '\n') {
                nextLine++;
                int last = text.length() - 1;
                if (last < 0 || text.charAt(last) != '\\') {
                    break;
                }
                text.setCharAt(last, ' ');
            } else if (character != '\r') {
                text.append((char) character);
            }
            InputException.refuseIf(
                    text.length() > LONGEST_LINE,
                    "longer than " + LONGEST_LINE + " characters; this is no OBJ text file");
        }
        boolean marked = line == 1 && text.indexOf(UTF8_MARK) == 0;
        return any ? text.substring(marked ? UTF8_MARK.length() : 0) : null;
    }

    /** Further numbers (weights, colors, a third texture coordinate) are ignored. */
    private static double[] numbers(StringTokenizer words, String what, int count) {
        // A one-dimensional texture has only u.
        int least = count == 2 ? 1 : count;
        if (words.countTokens() < least) {
            throw new InputException("a " + what + " needs " + least + " numbers, not " + words.countTokens());
        }
        double[] numbers = new double[count];
        for (int i = 0; i < count && words.hasMoreTokens(); i++) {
            numbers[i] = RawMesh.Builder.number(words.nextToken());
        }
        return numbers;
    }

    private void face(StringTokenizer words) {
        int count = words.countTokens();
        RawMesh.Builder.requireCorners(count);
        int[] polygon = new int[3 * count];
        for (int corner = 0; corner < count; corner++) {
            corner(words.nextToken(), polygon, 3 * corner);
            for (int kind = 1; kind < 3; kind++) {
                InputException.refuseIf(
                        (polygon[3 * corner + kind] < 0) != (polygon[kind] < 0),
                        "the face's corners differ in kind; give all of them texture coordinate and normal, or none");
            }
        }
        mesh.addFace(polygon);
    }

    /** Reads v, v/vt, v//vn or v/vt/vn into three indices; -1 for a missing one. */
    private void corner(String word, int[] polygon, int at) {
        String[] parts = word.split("/", -1);
        if (parts.length > 3 || (parts.length > 1 && parts[parts.length - 1].isEmpty())) {
            throw noCorner(word);
        }
        polygon[at] = index(word, parts[0], mesh.positions(), "position");
        polygon[at + 1] = parts.length < 2 || parts[1].isEmpty()
                ? -1
                : index(word, parts[1], mesh.textureCoordinates(), "texture coordinate");
        polygon[at + 2] = parts.length < 3 ? -1 : index(word, parts[2], mesh.normals(), "normal");
    }

    private InputException noCorner(String word) {
        return new InputException(
                Text.quoted(word) + " is no corner of a face; write v, v/vt, v//vn or v/vt/vn with whole numbers");
    }

    /** Converts an index, 1 for the first element or -1 for the last so far. */
    private int index(String word, String written, int count, String what) {
        if (!INDEX.matcher(written).matches()) {
            throw noCorner(word);
        }
        int number = Integer.parseInt(written);
        int index = number < 0 ? count + number : number - 1;
        if (index < 0 || index >= count) {
            throw new InputException("the face names " + what + " " + number + " but " + count + " are given above it");
        }
        return index;
    }
}
