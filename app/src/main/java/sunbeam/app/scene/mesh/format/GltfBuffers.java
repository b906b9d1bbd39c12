package sunbeam.app.scene.mesh.format;

import de.javagl.jgltf.impl.v2.Buffer;
import de.javagl.jgltf.impl.v2.BufferView;
import de.javagl.jgltf.impl.v2.GlTF;
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
import sunbeam.precompute.text.Quoted;

/** Buffers of a glTF file: its binary chunk, base64 data in its text, or files in its folder or below. Other addresses are refused. */
final class GltfBuffers {
    private static final Pattern URI_WITH_SCHEME = Pattern.compile("(?i)[a-z][a-z0-9+.-]*:.*", Pattern.DOTALL);
    private static final Pattern DATA = Pattern.compile("(?i)data:[^,]*;base64,");

    private final Path file;
    private final GlTF gltf;
    private final ByteBuffer binary;
    private final Map<Integer, ByteBuffer> loaded = new HashMap<>();

    GltfBuffers(Path file, GlTF gltf, ByteBuffer binary) {
        this.file = file;
        this.gltf = gltf;
        this.binary = binary;
    }

    /** Returns an entry of one of the document's lists; "what" names its kind in messages. */
    <T> T entry(List<T> list, Integer index, String what) {
        int count = list == null ? 0 : list.size();
        if (index == null || index < 0 || index >= count) {
            throw new InputException(
                    "it names " + what + " " + index + " of " + count + "; repair it or export it again");
        }
        return list.get(index);
    }

    /** Returns the bytes of a buffer view, little-endian, after a check that they lie in its buffer. */
    ByteBuffer view(BufferView view) throws IOException {
        ByteBuffer buffer = buffer(view.getBuffer());
        long offset = view.getByteOffset() == null ? 0 : view.getByteOffset();
        long length = view.getByteLength() == null ? -1 : view.getByteLength();
        if (offset < 0 || length < 1 || offset + length > buffer.limit()) {
            throw new InputException("a buffer view has " + length + " bytes from " + offset + " on in a buffer of "
                    + buffer.limit() + "; copy it again with its files");
        }
        return GltfFile.slice(buffer, (int) offset, (int) length);
    }

    private ByteBuffer buffer(Integer index) throws IOException {
        Buffer buffer = entry(gltf.getBuffers(), index, "buffer");
        if (!loaded.containsKey(index)) {
            loaded.put(index, load(buffer, index));
        }
        return loaded.get(index);
    }

    private ByteBuffer load(Buffer buffer, int index) throws IOException {
        String uri = buffer.getUri();
        if (uri == null) {
            if (index != 0 || binary.limit() == 0) {
                String extension = buffer.getExtensions() == null
                        ? ""
                        : " but by the extensions "
                                + Quoted.of(
                                        String.join(", ", buffer.getExtensions().keySet()));
                throw new InputException(
                        "buffer " + index + " has no data" + extension + "; export it again, uncompressed");
            }
            return binary;
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
            throw new InputException("buffer " + index + " lies at " + Quoted.of(uri)
                    + ", and nothing is fetched; put it into the folder, or export it as .glb");
        }
        return GltfFile.map(fileInFolder(uri));
    }

    private Path fileInFolder(String uri) {
        OwnFolder folder = new OwnFolder(file.toAbsolutePath(), "mesh");
        try {
            Path path = folder.file(decoded(uri));
            if (!Files.exists(path)) {
                throw new InputException("its buffer " + Quoted.of(uri) + " is missing; copy it into the folder, too");
            }
            folder.requireNoWayOut(path);
            InputException.requireRegular(path);
            return path;
        } catch (IllegalArgumentException out) {
            throw new InputException("its buffer " + Quoted.of(uri) + " " + out.getMessage(), out);
        }
    }

    private static String decoded(String uri) {
        try {
            // In a path, unlike in a form's data, a plus sign does not stand for a blank.
            return URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException broken) {
            throw new IllegalArgumentException(
                    "has a % without two hexadecimal digits; write %25, or export it again", broken);
        }
    }
}
