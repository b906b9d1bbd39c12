package sunbeam.app.scene.mesh;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.text.Text;

/**
 * Reader of a PLY file's geometry, text or binary. It reads of element {@code vertex} x, y, z, and optionally nx, ny, nz and texture
 * coordinates (u, v; s, t; texture_u, texture_v; texture_s, texture_t); of element {@code face} the list {@code vertex_indices} or {@code
 * vertex_index}, and optionally the list {@code texcoord} of each corner's texture coordinates; of element {@code tristrips} the list
 * {@code vertex_indices}, in which -1 ends a strip. All else is ignored.
 */
final class PlyFile {
    private static final int MOST_HEADER_LINES = 1000;
    private static final int LONGEST_HEADER_LINE = 1000;
    private static final double[] NO_TEXTURE = {};

    private final Encoding encoding;
    private final List<Element> elements;
    private final DataInputStream stream;
    private final ByteBuffer bytes;
    private final RawMesh.Builder mesh = new RawMesh.Builder();
    private boolean hasCoordinates;
    private boolean hasNormals;
    private Element element;
    private int row;

    private enum Encoding {
        ASCII,
        BINARY_LITTLE_ENDIAN,
        BINARY_BIG_ENDIAN
    }

    /** Column of numbers, or of lists whose length has a type. */
    private record Property(String name, Optional<SampleType> length, SampleType type) {}

    private record Element(String name, int count, List<Property> properties) {
        Element {
            if (count < 0) {
                throw new IllegalArgumentException("a negative count");
            }
        }

        /** Returns the first of these names that occurs, or -1. */
        int column(String... names) {
            List<String> all = properties.stream().map(Property::name).toList();
            return Stream.of(names)
                    .mapToInt(all::indexOf)
                    .filter(column -> column >= 0)
                    .findFirst()
                    .orElse(-1);
        }
    }

    private PlyFile(Encoding encoding, List<Element> elements, InputStream stream) {
        this.encoding = encoding;
        this.elements = elements;
        this.stream = new DataInputStream(stream);
        boolean isLittle = encoding == Encoding.BINARY_LITTLE_ENDIAN;
        this.bytes = ByteBuffer.allocate(Double.BYTES).order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    }

    static RawMesh read(Path file) throws IOException {
        try (InputStream stream = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            return withHeader(stream).mesh();
        }
    }

    private static PlyFile withHeader(InputStream stream) throws IOException {
        Encoding encoding = null;
        List<Element> elements = new ArrayList<>();
        for (int number = 1; number <= MOST_HEADER_LINES; number++) {
            String line = line(stream);
            String[] words = line.strip().split("\\s+");
            try {
                switch (words[0]) {
                    case "format" -> encoding = Encoding.valueOf(words[1].toUpperCase(Locale.ROOT));
                    case "element" ->
                        elements.add(new Element(words[1], Integer.parseInt(words[2]), new ArrayList<>()));
                    case "property" ->
                        elements.get(elements.size() - 1).properties().add(property(words));
                    case "end_header" -> {
                        if (encoding == null) {
                            throw new IllegalArgumentException("no format line is above it");
                        }
                        return new PlyFile(encoding, elements, stream);
                    }
                    case "ply", "comment", "obj_info" -> {
                        // No geometry.
                    }
                    default -> throw new IllegalArgumentException("no such line is known");
                }
            } catch (IllegalArgumentException | IndexOutOfBoundsException wrong) {
                throw new InputException(
                        "line " + number + " of the header, " + Text.quoted(line)
                                + ", cannot be understood; export the mesh again",
                        wrong);
            }
        }
        throw new InputException("the header has more than " + MOST_HEADER_LINES + " lines; export the mesh again");
    }

    /** Empty at the end of the file. */
    private static String line(InputStream stream) throws IOException {
        StringBuilder line = new StringBuilder();
        for (int next = stream.read(); next != '\n' && next >= 0; next = stream.read()) {
            line.append((char) next);
            InputException.refuseIf(
                    line.length() > LONGEST_HEADER_LINE,
                    "a line of the header is longer than " + LONGEST_HEADER_LINE
                            + " characters; export the mesh again");
        }
        return line.toString();
    }

    private static Property property(String[] words) {
        return words[1].equals("list")
                ? new Property(words[4], Optional.of(type(words[2])), type(words[3]))
                : new Property(words[2], Optional.empty(), type(words[1]));
    }

    private static SampleType type(String name) {
        return switch (name) {
            case "char", "int8" -> SampleType.SIGNED_8;
            case "uchar", "uint8" -> SampleType.UNSIGNED_8;
            case "short", "int16" -> SampleType.SIGNED_16;
            case "ushort", "uint16" -> SampleType.UNSIGNED_16;
            case "int", "int32" -> SampleType.SIGNED_32;
            case "uint", "uint32" -> SampleType.UNSIGNED_32;
            case "float", "float32" -> SampleType.FLOAT_32;
            case "double", "float64" -> SampleType.FLOAT_64;
            default -> throw new IllegalArgumentException("no type " + name);
        };
    }

    private RawMesh mesh() throws IOException {
        for (Element next : elements) {
            element = next;
            row = 0;
            try {
                rows();
            } catch (EOFException end) {
                throw new InputException(
                        element.name + " " + row + ": the file ends within it; copy or export it again", end);
            } catch (InputException wrong) {
                throw new InputException(element.name + " " + row + ": " + wrong.getMessage(), wrong);
            }
        }
        return mesh.build();
    }

    private void rows() throws IOException {
        int texture = element.column("texcoord");
        Consumer<double[][]> adding = switch (element.name) {
            case "vertex" -> vertices();
            case "face" -> {
                int corners = corners();
                yield values -> face(values[corners], texture < 0 ? NO_TEXTURE : values[texture]);
            }
            case "tristrips" -> {
                int corners = corners();
                yield values -> strips(values[corners]);
            }
            default -> values -> {};
        };
        double[][] values = new double[element.properties.size()][];
        for (; values.length > 0 && row < element.count; row++) {
            for (int column = 0; column < values.length; column++) {
                values[column] = next(element.properties.get(column), values[column]);
            }
            adding.accept(values);
        }
    }

    private Consumer<double[][]> vertices() {
        requireFew();
        int[] position = {element.column("x"), element.column("y"), element.column("z")};
        int[] normal = {element.column("nx"), element.column("ny"), element.column("nz")};
        int[] coordinates = {
            element.column("u", "s", "texture_u", "texture_s"), element.column("v", "t", "texture_v", "texture_t")
        };
        InputException.refuseIf(!areThere(position), "it has not x, y and z; export the mesh again");
        hasCoordinates = areThere(coordinates);
        hasNormals = areThere(normal);
        return values -> {
            mesh.addPosition(numbers(values, position));
            if (hasNormals) {
                mesh.addNormal(numbers(values, normal));
            }
            if (hasCoordinates) {
                mesh.addTextureCoordinate(numbers(values, coordinates));
            }
        };
    }

    private int corners() {
        requireFew();
        int corners = element.column("vertex_indices", "vertex_index");
        InputException.refuseIf(corners < 0, "it has no list vertex_indices; export the mesh again");
        return corners;
    }

    private void requireFew() {
        int most = RawMesh.Builder.MOST_ELEMENTS;
        InputException.refuseIf(
                element.count > most,
                element.count + " rows of element " + element.name + "; at most " + most
                        + " can be used, so simplify the mesh");
    }

    private static boolean areThere(int... columns) {
        return IntStream.of(columns).allMatch(column -> column >= 0);
    }

    /** The previous row's array is reused if it has the right length. */
    private double[] next(Property property, double[] reusable) throws IOException {
        double length = property.length().isPresent() ? number(property.length().get()) : 1;
        int most = element.name.equals("tristrips")
                ? 3 * RawMesh.Builder.MOST_ELEMENTS
                : 2 * RawMesh.Builder.MOST_POLYGON_CORNERS;
        if (!(length >= 0 && length <= most) || length != Math.rint(length)) {
            throw new InputException("a list of " + length + " numbers; 0 to " + most + " can be used");
        }
        double[] values = reusable != null && reusable.length == (int) length ? reusable : new double[(int) length];
        for (int i = 0; i < values.length; i++) {
            values[i] = number(property.type());
        }
        return values;
    }

    private static double[] numbers(double[][] values, int... columns) {
        return IntStream.of(columns)
                .mapToDouble(column -> {
                    InputException.refuseIf(
                            values[column].length != 1, "a list where a number belongs; export the mesh again");
                    return values[column][0];
                })
                .toArray();
    }

    /** @param corners -1 or the list's end ends a strip. Every second triangle has two corners exchanged */
    private void strips(double[] corners) {
        int start = 0;
        for (int i = 0; i < corners.length; i++) {
            if (corners[i] == -1) {
                start = i + 1;
            } else if (i - start >= 2) {
                int odd = (i - start) % 2;
                face(new double[] {corners[i - 2], corners[i - 1 + odd], corners[i - odd]}, NO_TEXTURE);
            }
        }
    }

    private void face(double[] corners, double[] texture) {
        int count = corners.length;
        RawMesh.Builder.requireCorners(count);
        boolean ownTexture = texture.length > 0;
        if (ownTexture && texture.length != 2 * count) {
            throw new InputException(
                    texture.length + " texture coordinates of " + count + " corners; give two for each");
        }
        int[] polygon = new int[3 * count];
        for (int i = 0; i < count; i++) {
            int vertex = vertex(corners[i]);
            int coordinate = ownTexture ? mesh.textureCoordinates() : hasCoordinates ? vertex : -1;
            if (ownTexture) {
                mesh.addTextureCoordinate(texture[2 * i], texture[2 * i + 1]);
            }
            polygon[3 * i] = vertex;
            polygon[3 * i + 1] = coordinate;
            polygon[3 * i + 2] = hasNormals ? vertex : -1;
        }
        mesh.addFace(polygon);
    }

    private int vertex(double index) {
        if (!(index >= 0 && index < mesh.positions()) || index != Math.rint(index)) {
            throw new InputException("it names vertex " + index + " but " + mesh.positions()
                    + " are given above it; repair the mesh or export it again");
        }
        return (int) index;
    }

    private double number(SampleType type) throws IOException {
        if (encoding == Encoding.ASCII) {
            return word();
        }
        stream.readFully(bytes.array(), 0, type.size());
        return type.decode(bytes, 0);
    }

    private double word() throws IOException {
        StringBuilder word = new StringBuilder();
        int next = stream.read();
        while (next >= 0 && next <= ' ') {
            next = stream.read();
        }
        while (next > ' ' && word.length() <= 60) {
            word.append((char) next);
            next = stream.read();
        }
        if (word.isEmpty()) {
            throw new EOFException();
        }
        return RawMesh.Builder.number(word.toString());
    }
}
