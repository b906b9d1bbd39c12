package sunbeam.app.render;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import sunbeam.app.cli.Version;
import sunbeam.app.mesh.Mesh;
import sunbeam.app.picture.PictureParameters;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneWriter;

/** What tells whether a picture that is there is the one that would be drawn: a hash of all that determines it. */
final class FrameIdentity {
    /** Keyword of the PNG's text that holds it. */
    static final String KEYWORD = PictureParameters.KEYWORD;

    private final String inputs;

    /** @param data what the frames' scenes share */
    FrameIdentity(SceneData data, PictureSize size, int supersample) {
        MessageDigest digest = PictureParameters.sha256();
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
        return PictureParameters.hash(inputs + SceneWriter.describe(scene));
    }

    /** Whether a file is a frame with this hash. A file that is damaged or no PNG is not. */
    static boolean matches(Path file, String identity) {
        return PictureParameters.find(file, identity).isPresent();
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
}
