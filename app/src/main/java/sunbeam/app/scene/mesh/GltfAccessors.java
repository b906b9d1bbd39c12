package sunbeam.app.scene.mesh;

import static de.javagl.jgltf.model.GltfConstants.GL_BYTE;
import static de.javagl.jgltf.model.GltfConstants.GL_FLOAT;
import static de.javagl.jgltf.model.GltfConstants.GL_SHORT;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_BYTE;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_INT;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_SHORT;

import de.javagl.jgltf.impl.v2.Accessor;
import de.javagl.jgltf.impl.v2.AccessorSparse;
import de.javagl.jgltf.impl.v2.AccessorSparseIndices;
import de.javagl.jgltf.impl.v2.AccessorSparseValues;
import de.javagl.jgltf.impl.v2.Buffer;
import de.javagl.jgltf.impl.v2.BufferView;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.text.Text;

/**
 * Reads accessors of glTF 2.0 (its section 3.6.2), dense and sparse. Buffers are the file's binary chunk, base64 data in its text, or files
 * in its folder or below; other addresses are refused.
 */
final class GltfAccessors {
    private static final int MOST_ELEMENTS = 3 * RawMesh.Builder.MOST_ELEMENTS;
    private static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4);
    private static final Map<Integer, SampleType> TYPES = Map.of(
            GL_BYTE, SampleType.SIGNED_8,
            GL_UNSIGNED_BYTE, SampleType.UNSIGNED_8,
            GL_SHORT, SampleType.SIGNED_16,
            GL_UNSIGNED_SHORT, SampleType.UNSIGNED_16,
            GL_UNSIGNED_INT, SampleType.UNSIGNED_32,
            GL_FLOAT, SampleType.FLOAT_32);

    private static final Pattern URI_WITH_SCHEME = Pattern.compile("(?i)[a-z][a-z0-9+.-]*:.*", Pattern.DOTALL);
    private static final Pattern DATA = Pattern.compile("(?i)data:[^,]*;base64,");

    private final Path file;
    private final GltfDocument document;
    private final Map<Integer, ByteBuffer> loaded = new HashMap<>();

    GltfAccessors(Path file, GltfDocument document) {
        this.file = file;
        this.document = document;
    }

    /** Numbers of a type in a buffer view. */
    private record Place(Integer componentType, Integer view, Integer offset) {}

    /** Returns at most three times {@link RawMesh.Builder#MOST_ELEMENTS}, the corners of as many triangles. */
    int count(Integer index) {
        Integer count = entry(document.gltf().getAccessors(), index, "accessor").getCount();
        String most = "; 1 to " + MOST_ELEMENTS + " can be used, so simplify the mesh";
        refuseIf(count == null || count > MOST_ELEMENTS, index, "has " + count + " elements" + most);
        return count;
    }

    double[] read(Integer index, int components) throws IOException {
        Accessor accessor = entry(document.gltf().getAccessors(), index, "accessor");
        Integer known = COMPONENTS.getOrDefault(String.valueOf(accessor.getType()), 0);
        refuseIf(known != components, index, "has not " + components + " numbers each; export it again");
        int count = count(index);
        Place place = new Place(accessor.getComponentType(), accessor.getBufferView(), accessor.getByteOffset());
        double[] values =
                place.view == null ? new double[components * count] : numbers(index, place, components, count);
        if (accessor.getSparse() != null) {
            substitute(index, accessor, values, components);
        }
        normalize(accessor, values);
        return values;
    }

    private void substitute(Integer index, Accessor accessor, double[] values, int components) throws IOException {
        AccessorSparse sparse = accessor.getSparse();
        AccessorSparseIndices places = sparse.getIndices();
        AccessorSparseValues contents = sparse.getValues();
        Integer count = sparse.getCount();
        int elements = values.length / components;
        boolean whole = count != null && count > 0 && count <= elements && places != null && contents != null;
        refuseIf(!whole, index, "has sparse values that cannot be understood; export it again");
        Place place = new Place(places.getComponentType(), places.getBufferView(), places.getByteOffset());
        double[] at = numbers(index, place, 1, count);
        Place content = new Place(accessor.getComponentType(), contents.getBufferView(), contents.getByteOffset());
        double[] numbers = numbers(index, content, components, count);
        for (int i = 0; i < count; i++) {
            if (!(at[i] >= 0 && at[i] < elements)) {
                throw new InputException(
                        "accessor " + index + " has a sparse value for element " + (long) at[i] + "; export it again");
            }
            System.arraycopy(numbers, components * i, values, components * (int) at[i], components);
        }
    }

    /** Divides normalized integers by their largest value (glTF 2.0, 3.6.2.2). */
    private static void normalize(Accessor accessor, double[] values) {
        if (!Boolean.TRUE.equals(accessor.isNormalized()) || accessor.getComponentType() == null) {
            return;
        }
        double one = switch (accessor.getComponentType()) {
            case GL_BYTE -> Byte.MAX_VALUE;
            case GL_UNSIGNED_BYTE -> 255;
            case GL_SHORT -> Short.MAX_VALUE;
            case GL_UNSIGNED_SHORT -> 65535;
            default -> 0;
        };
        for (int i = 0; one > 0 && i < values.length; i++) {
            values[i] = Math.max(-1, values[i] / one);
        }
    }

    /** Returns the numbers of a buffer view; the accessor's index is for messages. */
    private double[] numbers(Integer index, Place place, int components, int count) throws IOException {
        BufferView view = entry(document.gltf().getBufferViews(), place.view, "buffer view");
        ByteBuffer all = view(view);
        SampleType type = place.componentType == null ? null : TYPES.get(place.componentType);
        int first = place.offset == null ? 0 : place.offset;
        int bytes = type == null ? 0 : type.size() * components;
        int stride = view.getByteStride() == null ? bytes : view.getByteStride();
        long end = first + (long) stride * (count - 1) + bytes;
        boolean fits = bytes > 0 && first >= 0 && stride >= bytes && end <= all.limit();
        String room = "needs " + end + " bytes of a buffer view that has " + all.limit();
        refuseIf(!fits, index, room + "; copy it again with its files");
        double[] numbers = new double[components * count];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = type.decode(all, first + i / components * stride + i % components * type.size());
        }
        return numbers;
    }

    private static void refuseIf(boolean condition, Integer index, String what) {
        InputException.refuseIf(condition, "accessor " + index + " " + what);
    }

    /** Returns an entry of a list of the document; "what" names its kind in messages. */
    <T> T entry(List<T> list, Integer index, String what) {
        int count = list == null ? 0 : list.size();
        InputException.refuseIf(
                index == null || index < 0 || index >= count,
                "it names " + what + " " + index + " of " + count + "; repair it or export it again");
        return list.get(index);
    }

    /** Returns a buffer view's bytes, little-endian, after a check that they lie in its buffer. */
    private ByteBuffer view(BufferView view) throws IOException {
        ByteBuffer buffer = buffer(view.getBuffer());
        long offset = view.getByteOffset() == null ? 0 : view.getByteOffset();
        long length = view.getByteLength() == null ? -1 : view.getByteLength();
        InputException.refuseIf(
                offset < 0 || length < 1 || offset + length > buffer.limit(),
                "a buffer view has " + length + " bytes from " + offset + " on in a buffer of " + buffer.limit()
                        + "; copy it again with its files");
        return GltfDocument.slice(buffer, (int) offset, (int) length);
    }

    private ByteBuffer buffer(Integer index) throws IOException {
        Buffer buffer = entry(document.gltf().getBuffers(), index, "buffer");
        if (!loaded.containsKey(index)) {
            loaded.put(index, load(buffer, index));
        }
        return loaded.get(index);
    }

    private ByteBuffer load(Buffer buffer, int index) throws IOException {
        String uri = buffer.getUri();
        if (uri == null) {
            if (index != 0 || document.binary().limit() == 0) {
                String extension = buffer.getExtensions() == null
                        ? ""
                        : " but by the extensions "
                                + Text.quoted(
                                        String.join(", ", buffer.getExtensions().keySet()));
                throw new InputException(
                        "buffer " + index + " has no data" + extension + "; export it again, uncompressed");
            }
            return document.binary();
        }
        var data = DATA.matcher(uri);
        if (data.lookingAt()) {
            try {
                return ByteBuffer.wrap(Base64.getDecoder().decode(uri.substring(data.end())))
                        .order(ByteOrder.LITTLE_ENDIAN);
            } catch (IllegalArgumentException broken) {
                throw new InputException("the data of buffer " + index + " is no base64; export it again", broken);
            }
        }
        if (URI_WITH_SCHEME.matcher(uri).matches()) {
            throw new InputException("buffer " + index + " lies at " + Text.quoted(uri)
                    + ", and nothing is fetched; put it into the folder, or export it as .glb");
        }
        return GltfDocument.map(fileInFolder(uri));
    }

    private Path fileInFolder(String uri) {
        OwnFolder folder = new OwnFolder(file.toAbsolutePath(), "mesh");
        try {
            Path path = folder.file(decoded(uri));
            InputException.refuseIf(
                    !Files.exists(path),
                    "its buffer " + Text.quoted(uri) + " is missing; copy it into the folder, too");
            folder.requireNoWayOut(path);
            InputException.requireRegular(path);
            return path;
        } catch (IllegalArgumentException out) {
            throw new InputException("its buffer " + Text.quoted(uri) + " " + out.getMessage(), out);
        }
    }

    private static String decoded(String uri) {
        try {
            // In a path, unlike a form's data, a plus sign is no blank.
            return URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException broken) {
            throw new IllegalArgumentException(
                    "has a % without two hexadecimal digits; write %25, or export it again", broken);
        }
    }
}
