package sunbeam.app.cli;

import static sunbeam.app.scene.SceneSettings.MESH_UNIT;
import static sunbeam.app.scene.SceneSettings.SCALES;
import static sunbeam.app.scene.SceneSettings.TEXTURE;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.MeshWriters;
import sunbeam.app.scene.mesh.SkinMaps;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.Scales;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;

/** {@code sunbeam mesh}: writes a mesh for scenes or other programs. */
@Command(
        name = "mesh",
        header = "Generate or check a mesh.",
        description = "Generate a mesh, or check one, and write it with normals and with texture coordinates whose u"
                + " gives the direction of the nanostructure: as OBJ or PLY, meters, z up; or as binary glTF, y up,"
                + " with tangents, and with the body's colors and the scales' normals as pictures.",
        footer = {
            "  sunbeam mesh snake --output snake.glb",
            "  sunbeam mesh beetle.ply --mesh-unit mm --output beetle.obj"
        })
public final class MeshCommand extends FileCommand {
    @Parameters(
            paramLabel = "MESH",
            description = "snake: coiled, 1.3 m long, with scales in its normals. plane: a square of 0.2 m. sphere: of"
                    + " radius 0.1 m. ellipsoid: half axes 0.1, 0.065 and 0.045 m. cylinder: an open mantle, radius 0.1 m, 0.2 m high. disc: a compact disc. Or a file, OBJ, PLY or glTF, which is"
                    + " checked, divided into triangles and completed.")
    private String mesh;

    @Mixin
    private final SettingOptions options = new SettingOptions(
            List.of(MESH_UNIT, TEXTURE, SCALES),
            Map.of(TEXTURE, "of snake elaphe, else none; for .glb", SCALES, "of snake keeled; for .glb"));

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description = "The file to write: .obj, .ply or .glb. Default: MESH.obj in the current folder.")
    private Path output;

    @Override
    public Integer call() {
        Ending.MESH.require("--output", output);
        Overwrite overwrite = overwrite(output);
        Path target = output != null ? output : Path.of(FileNames.stem(Path.of(mesh)) + ".obj");
        Choices choices = options.choices();
        String ending = Ending.of(target);
        boolean isGltf = ending.equals("glb");
        check(choices, isGltf);
        AtomicFile.checkWritable(target, overwrite);
        MeshSource.Loaded read = new MeshSource(mesh, choices.get(MESH_UNIT)).load();
        read.warnings().forEach(warning -> err().println(Messages.warning(warning)));
        Optional<SkinMaps> maps = isGltf ? skinMaps(choices) : Optional.empty();
        Path written = AtomicFile.write(target, overwrite, stream -> {
            if (isGltf) {
                MeshWriters.glb(stream, read.mesh(), maps);
            } else if (ending.equals("ply")) {
                MeshWriters.ply(stream, read.mesh());
            } else {
                MeshWriters.obj(stream, read.mesh());
            }
        });
        int vertices = read.mesh().vertices();
        int triangles = read.mesh().triangles();
        List<Double> sides = Stream.of(0, 1, 2).map(read.mesh()::side).toList();
        PrintWriter out = out(target);
        if (json.isGiven()) {
            var report = Map.of("mesh", mesh, "vertices", vertices, "triangles", triangles, "sides_m", sides);
            json.print(out, new TreeMap<>(report), List.of(written));
        } else {
            out.println(OutputFolder.name(written) + ": " + MeshSource.count(vertices, "vertex") + ", "
                    + MeshSource.count(triangles, "triangle")
                    + Text.format(", %.3g x %.3g x %.3g m", sides.toArray()));
        }
        return ExitCode.OK.code();
    }

    private boolean isSnake() {
        return mesh.equals("snake");
    }

    private void check(Choices choices, boolean isGltf) {
        for (Setting<?> setting : List.of(TEXTURE, SCALES)) {
            if (choices.has(setting) && !isGltf) {
                throw choices.complaint(setting, "needs a format with pictures; end --output with .glb");
            }
        }
        if (!isSnake() && choices.get(SCALES, Scales.NONE) != Scales.NONE) {
            throw choices.complaint(SCALES, "is for mesh snake; leave it out");
        }
    }

    private Optional<SkinMaps> skinMaps(Choices choices) {
        String texture = choices.get(TEXTURE, isSnake() ? "elaphe" : Body.NONE);
        Scales scales = choices.get(SCALES, isSnake() ? Scales.KEELED : Scales.NONE);
        if (texture.equals(Body.NONE) && scales == Scales.NONE) {
            return Optional.empty();
        }
        return Optional.of(
                SkinMaps.of(Body.load(texture, scales, Body.NONE, Body.patches(Body.NONE, List.of()), BlobCache.NONE)));
    }
}
