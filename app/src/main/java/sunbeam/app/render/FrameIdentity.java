package sunbeam.app.render;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import sunbeam.app.cli.Version;
import sunbeam.app.input.InputException;
import sunbeam.app.input.PngText;
import sunbeam.app.mesh.Mesh;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneWriter;

/** What tells whether a picture that is there is the one that would be drawn: a hash of all that determines it. */
final class FrameIdentity {
    /** Keyword of the PNG's text that holds it. */
    static final String KEYWORD = "Parameters";

    private final String inputs;

    /** @param data what the frames' scenes share */
    FrameIdentity(SceneData data, PictureSize size, int supersample) {
        MessageDigest digest = sha256();
        addMesh(digest, data.mesh());
        digest.update(data.body().rgba());
        String meshAndBody = HexFormat.of().formatHex(digest.digest());
        inputs = String.join(
                "|",
                Version.number(),
                data.patch().digest(),
                meshAndBody,
                size.toString(),
                "supersample " + supersample);
    }

    /** The hash for one frame. */
    String of(Scene scene) {
        MessageDigest digest = sha256();
        digest.update((inputs + SceneWriter.describe(scene)).getBytes(StandardCharsets.UTF_8));
        return HexFormat.of().formatHex(digest.digest());
    }

    /** Whether a file is a frame with this hash. A file that is damaged or no PNG is not. */
    static boolean matches(Path file, String identity) {
        if (!Files.exists(file)) {
            return false;
        }
        try {
            return identity.equals(PngText.read(file).get(KEYWORD));
        } catch (InputException unreadable) {
            // Whatever it is, it is not the frame; whether it may be replaced is decided elsewhere.
            return false;
        }
    }

    private static void addMesh(MessageDigest digest, Mesh mesh) {
        for (float[] values :
                new float[][] {mesh.positions(), mesh.normals(), mesh.tangents(), mesh.textureCoordinates()}) {
            ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length);
            bytes.asFloatBuffer().put(values);
            digest.update(bytes);
        }
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * mesh.indices().length);
        bytes.asIntBuffer().put(mesh.indices());
        digest.update(bytes);
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
