package sunbeam.app.commands.render;

import java.nio.file.Path;
import sunbeam.app.gpu.picture.PictureParameters;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.SkinPart;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.files.Sha256;

/** What tells whether a picture that is there is the one that would be drawn: a hash of all that determines it. */
final class FrameIdentity {
    /** Keyword of the PNG's text that holds it. */
    static final String KEYWORD = PictureParameters.KEYWORD;

    private final String inputs;

    /** @param data what the frames' scenes share */
    FrameIdentity(SceneData data, PictureSize size, int supersample) {
        Mesh mesh = data.mesh();
        String meshAndBody = new Sha256()
                .add(mesh.positions())
                .add(mesh.normals())
                .add(mesh.tangents())
                .add(mesh.textureCoordinates())
                .add(mesh.indices())
                .add(data.body().rgba())
                .hex();
        inputs = String.join(
                "|",
                Version.number(),
                data.patch().digest(),
                data.part().map(SkinPart::digest).orElse(""),
                meshAndBody,
                size.toString(),
                "supersample " + supersample);
    }

    /** The hash for one frame. */
    String of(Scene scene) {
        return Sha256.of(inputs + SceneWriter.describe(scene));
    }

    /** Whether a file is a frame with this hash. A file that is damaged or no PNG is not. */
    static boolean matches(Path file, String identity) {
        return PictureParameters.find(file, identity).isPresent();
    }
}
