package sunbeam.app.scene.mesh.format;

import static sunbeam.app.scene.mesh.format.MeshLimits.MOST;
import static sunbeam.app.scene.mesh.format.MeshLimits.MOST_CORNERS;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.StringTokenizer;
import java.util.function.DoubleConsumer;
import java.util.regex.Pattern;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Quoted;

/**
 * The geometry of an OBJ file, line by line: positions, normals, texture coordinates, and faces, which are divided into triangles. All else
 * (groups, materials, lines, curves) is ignored.
 */
final class ObjFile {
    private static final int LONGEST_LINE = 1 << 16;
    private static final String UTF8_MARK = "\u00EF\u00BB\u00BF";
    private static final Pattern INDEX = Pattern.compile("-?[1-9]\\d{0,8}");

    private final Path file;
    private final BufferedReader reader;
    private final RawMeshBuilder mesh = new RawMeshBuilder();
    private long line;
    private long next = 1;

    private ObjFile(Path file, BufferedReader reader) {
        this.file = file;
        this.reader = reader;
    }

    static RawMesh read(Path file) {
        // Any byte is a character in Latin 1; geometry is ASCII.
        try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.ISO_8859_1)) {
            return new ObjFile(file, reader).mesh();
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private InputException wrong(String what) {
        return new InputException(file + ", line " + line + ": " + what);
    }

    private RawMesh mesh() throws IOException {
        for (String text = readLine(); text != null; text = readLine()) {
            int comment = text.indexOf('#');
            StringTokenizer words = new StringTokenizer(comment < 0 ? text : text.substring(0, comment));
            switch (words.hasMoreTokens() ? words.nextToken() : "") {
                case "v" -> numbers(words, mesh.positions::addElement, mesh.vertices(), "position", 3);
                case "vn" -> numbers(words, mesh.normals::add, mesh.normals.size() / 3, "normal", 3);
                case "vt" ->
                    numbers(
                            words,
                            mesh.textureCoordinates::add,
                            mesh.textureCoordinates.size() / 2,
                            "texture coordinate",
                            2);
                case "f" -> face(words);
                default -> {
                    // No geometry.
                }
            }
        }
        return mesh.build();
    }

    /** Reads a line with its continuations; null at the end. */
    private String readLine() throws IOException {
        line = next;
        StringBuilder text = new StringBuilder();
        boolean any = false;
        for (int character = reader.read(); character >= 0; character = reader.read()) {
            any = true;
            if (character == '\n') {
                next++;
                int last = text.length() - 1;
                if (last < 0 || text.charAt(last) != '\\') {
                    break;
                }
                text.setCharAt(last, ' ');
            } else if (character != '\r') {
                text.append((char) character);
            }
            if (text.length() > LONGEST_LINE) {
                throw wrong("longer than " + LONGEST_LINE + " characters; this is no OBJ text file");
            }
        }
        boolean marked = line == 1 && text.indexOf(UTF8_MARK) == 0;
        return any ? text.substring(marked ? UTF8_MARK.length() : 0) : null;
    }

    /** Reads the first numbers of the line; further ones (weights, colors, a third texture coordinate) are ignored. */
    private void numbers(StringTokenizer words, DoubleConsumer list, int before, String what, int count) {
        // One texture coordinate is a texture along a line.
        int least = count == 2 ? 1 : count;
        if (words.countTokens() < least) {
            throw wrong("a " + what + " needs " + least + " numbers, not " + words.countTokens());
        }
        if (before >= MOST) {
            throw wrong("more than " + MOST + " " + what + "s; simplify the mesh");
        }
        for (int i = 0; i < count; i++) {
            list.accept(words.hasMoreTokens() ? number(words.nextToken()) : 0);
        }
    }

    private double number(String word) {
        try {
            double value = Double.parseDouble(word);
            if (MeshLimits.allows(value)) {
                return value;
            }
        } catch (NumberFormatException failure) {
            throw wrong(Quoted.of(word) + " is no number; export the mesh again");
        }
        throw wrong(Quoted.of(word) + " is " + MeshLimits.NUMBERS);
    }

    private void face(StringTokenizer words) {
        int count = words.countTokens();
        if (count < 3 || count > MOST_CORNERS) {
            throw wrong("a face with " + count + " corners; 3 to " + MOST_CORNERS + " can be used");
        }
        if (mesh.triangles() + count - 2 > MOST) {
            throw wrong("more than " + MOST + " triangles; simplify the mesh");
        }
        int[] polygon = new int[3 * count];
        for (int corner = 0; corner < count; corner++) {
            corner(words.nextToken(), polygon, 3 * corner);
            for (int kind = 1; kind < 3; kind++) {
                if ((polygon[3 * corner + kind] < 0) != (polygon[kind] < 0)) {
                    throw wrong(
                            "the face's corners differ in kind; give all of them texture coordinate and normal, or none");
                }
            }
        }
        mesh.face(polygon);
    }

    /** Reads v, v/vt, v//vn or v/vt/vn: position, texture coordinate, normal; -1 for a missing one. */
    private void corner(String word, int[] polygon, int at) {
        String[] parts = word.split("/", -1);
        boolean isOne = parts.length <= 3 && (parts.length < 2 || !parts[parts.length - 1].isEmpty());
        if (!isOne) {
            throw noCorner(word);
        }
        polygon[at] = index(word, parts[0], mesh.vertices(), "position");
        polygon[at + 1] = parts.length < 2 || parts[1].isEmpty()
                ? -1
                : index(word, parts[1], mesh.textureCoordinates.size() / 2, "texture coordinate");
        polygon[at + 2] = parts.length < 3 ? -1 : index(word, parts[2], mesh.normals.size() / 3, "normal");
    }

    private InputException noCorner(String word) {
        return wrong(Quoted.of(word) + " is no corner of a face; write v, v/vt, v//vn or v/vt/vn with whole numbers");
    }

    /** Converts the file's index (from 1, or backwards from -1 for the last) to one from 0. */
    private int index(String word, String written, int count, String what) {
        if (!INDEX.matcher(written).matches()) {
            throw noCorner(word);
        }
        int number = Integer.parseInt(written);
        int index = number < 0 ? count + number : number - 1;
        if (index < 0 || index >= count) {
            throw wrong("the face names " + what + " " + number + " but " + count + " are given above it");
        }
        return index;
    }
}
