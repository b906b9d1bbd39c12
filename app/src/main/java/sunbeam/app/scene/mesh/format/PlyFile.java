package sunbeam.app.scene.mesh.format;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.text.Quoted;

/**
 * Reader of a PLY file's geometry, text or binary. It reads of element {@code vertex} x, y, z, and optionally nx, ny, nz and texture
 * coordinates (u, v; s, t; texture_u, texture_v; texture_s, texture_t); of element {@code face} the list {@code vertex_indices} or {@code
 * vertex_index}, and optionally the list {@code texcoord} of each corner's texture coordinates; of element {@code tristrips} the list
 * {@code vertex_indices}, in which -1 ends a strip. All else is ignored.
 */
final class PlyFile {
    private static final double[] NO_TEXTURE = {};

    private final Path file;
    private final PlyHeader header;
    private final DataInputStream stream;
    private final ByteBuffer bytes;
    private final RawMeshBuilder mesh = new RawMeshBuilder();
    private int vertices;
    private boolean hasCoordinates;
    private boolean hasNormals;
    private String element = "header";

    private int row;

    private PlyFile(Path file, PlyHeader header, InputStream stream) {
        this.file = file;
        this.header = header;
        this.stream = new DataInputStream(stream);
        boolean isLittle = header.encoding() == PlyHeader.Encoding.BINARY_LITTLE_ENDIAN;
        this.bytes = ByteBuffer.allocate(Double.BYTES).order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    }

    static RawMesh read(Path file) {
        try (InputStream stream = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            return new PlyFile(file, header(file, stream), stream).mesh();
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private static PlyHeader header(Path file, InputStream stream) throws IOException {
        try {
            return PlyHeader.read(stream);
        } catch (IllegalArgumentException wrong) {
            throw new InputException(file + ": " + wrong.getMessage(), wrong);
        }
    }

    private RawMesh mesh() throws IOException {
        for (PlyHeader.Element next : header.elements()) {
            element = next.name();
            row = 0;
            if (next.count() > MeshLimits.MOST_ELEMENTS && (isVertex() || isFace() || isStrips())) {
                throw new InputException(file + ": " + next.count() + " rows of element " + element + "; at most "
                        + MeshLimits.MOST_ELEMENTS + " can be used, so simplify the mesh");
            }
            try {
                rows(next);
            } catch (EOFException end) {
                throw wrong("the file ends within it; copy or export it again");
            } catch (IllegalArgumentException none) {
                throw wrong(none.getMessage());
            }
        }
        return mesh.build();
    }

    private boolean isVertex() {
        return element.equals("vertex");
    }

    private boolean isFace() {
        return element.equals("face");
    }

    private boolean isStrips() {
        return element.equals("tristrips");
    }

    private InputException wrong(String what) {
        return new InputException(file + ", " + element + " " + row + ": " + what);
    }

    private void rows(PlyHeader.Element table) throws IOException {
        int[] position = {table.column("x"), table.column("y"), table.column("z")};
        int[] normal = {table.column("nx"), table.column("ny"), table.column("nz")};
        int[] coordinates = {
            table.column("u", "s", "texture_u", "texture_s"), table.column("v", "t", "texture_v", "texture_t")
        };
        int corners = table.column("vertex_indices", "vertex_index");
        if (isVertex()) {
            hasCoordinates = areThere(coordinates);
            hasNormals = areThere(normal);
            if (!areThere(position)) {
                throw new IllegalArgumentException("it has not x, y and z; export the mesh again");
            }
        } else if ((isFace() || isStrips()) && corners < 0) {
            throw new IllegalArgumentException("it has no list vertex_indices; export the mesh again");
        }
        int width = table.properties().size();
        if (width == 0) {
            return;
        }
        int texture = table.column("texcoord");
        double[][] values = new double[width][];
        for (; row < table.count(); row++) {
            for (int column = 0; column < width; column++) {
                values[column] = next(table.properties().get(column), values[column]);
            }
            if (isVertex()) {
                vertices++;
                add(mesh.positions::addElement, values, position);
                add(mesh.normals::add, values, hasNormals ? normal : new int[0]);
                add(mesh.textureCoordinates::add, values, hasCoordinates ? coordinates : new int[0]);
            } else if (isFace()) {
                face(values[corners], texture < 0 ? NO_TEXTURE : values[texture]);
            } else if (isStrips()) {
                strips(values[corners]);
            }
        }
    }

    private static boolean areThere(int... columns) {
        return IntStream.of(columns).allMatch(column -> column >= 0);
    }

    /** Reads a property's numbers in the current row, into the previous row's array if that has the right length. */
    private double[] next(PlyHeader.Property property, double[] reusable) throws IOException {
        double length = property.length().isPresent() ? number(property.length().get()) : 1;
        int most = isStrips() ? 3 * MeshLimits.MOST_ELEMENTS : 2 * MeshLimits.MOST_POLYGON_CORNERS;
        if (!(length >= 0 && length <= most) || length != Math.rint(length)) {
            throw new IllegalArgumentException("a list of " + length + " numbers; 0 to " + most + " can be used");
        }
        double[] values = reusable != null && reusable.length == (int) length ? reusable : new double[(int) length];
        for (int i = 0; i < values.length; i++) {
            values[i] = number(property.type());
        }
        return values;
    }

    private static void add(DoubleConsumer list, double[][] values, int... columns) {
        for (int column : columns) {
            if (values[column].length != 1) {
                throw new IllegalArgumentException("a list where a number belongs; export the mesh again");
            }
            add(list, values[column][0]);
        }
    }

    private static void add(DoubleConsumer list, double value) {
        if (!MeshLimits.allows(value)) {
            throw new IllegalArgumentException(value + " is " + MeshLimits.BAD_NUMBER);
        }
        list.accept(value);
    }

    /** @param corners vertex indices of strips; -1 or the list's end ends a strip. Every second triangle has two corners exchanged */
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
        if (count < 3 || count > MeshLimits.MOST_POLYGON_CORNERS) {
            throw new IllegalArgumentException(
                    "it has " + count + " corners; 3 to " + MeshLimits.MOST_POLYGON_CORNERS + " can be used");
        }
        if (mesh.triangles() + count - 2 > MeshLimits.MOST_ELEMENTS) {
            throw new IllegalArgumentException(
                    "more than " + MeshLimits.MOST_ELEMENTS + " triangles; simplify the mesh");
        }
        boolean ownTexture = texture.length > 0;
        if (ownTexture && texture.length != 2 * count) {
            throw new IllegalArgumentException(
                    texture.length + " texture coordinates of " + count + " corners; give two for each");
        }
        int[] polygon = new int[3 * count];
        for (int i = 0; i < count; i++) {
            int vertex = vertex(corners[i]);
            int coordinate = ownTexture ? mesh.textureCoordinates.size() / 2 : hasCoordinates ? vertex : -1;
            if (ownTexture) {
                add(mesh.textureCoordinates::add, texture[2 * i]);
                add(mesh.textureCoordinates::add, texture[2 * i + 1]);
            }
            polygon[3 * i] = vertex;
            polygon[3 * i + 1] = coordinate;
            polygon[3 * i + 2] = hasNormals ? vertex : -1;
        }
        mesh.face(polygon);
    }

    private int vertex(double index) {
        if (!(index >= 0 && index < vertices) || index != Math.rint(index)) {
            throw new IllegalArgumentException("it names vertex " + index + " but " + vertices
                    + " are given above it; repair the mesh or export it again");
        }
        return (int) index;
    }

    private double number(SampleType type) throws IOException {
        if (header.encoding() == PlyHeader.Encoding.ASCII) {
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
        try {
            return Double.parseDouble(word.toString());
        } catch (NumberFormatException wrong) {
            throw new IllegalArgumentException(
                    Quoted.of(word.toString()) + " is no number; export the mesh again", wrong);
        }
    }
}
