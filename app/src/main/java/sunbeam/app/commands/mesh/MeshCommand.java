package sunbeam.app.commands.mesh;

import static sunbeam.app.scene.SceneSettings.MESH_UNIT;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.scene.mesh.MeshReader;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.MeshWriter;
import sunbeam.app.scene.mesh.ReadMesh;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.SettingOptions;

/** {@code sunbeam mesh}: writes a mesh that scenes can use, or that other programs can change. */
@Command(
        name = "mesh",
        header = "Generate or check a mesh.",
        description =
                "Generate a mesh, or check one, and write it as Wavefront OBJ: metres, z up, with normals and with"
                        + " texture coordinates whose u gives the direction of the nanostructure.")
public final class MeshCommand implements Callable<Integer> {
    @Mixin
    private ForceOption force;

    @Parameters(
            paramLabel = "MESH",
            description = "snake: coiled, 1.3 m long, with scales in its normals. plane: a square of 0.2 m. sphere: of"
                    + " radius 0.1 m. cylinder: an open mantle, radius 0.1 m, 0.2 m high. Or a file, OBJ, PLY or glTF, which is"
                    + " checked, divided into triangles and completed.")
    private String mesh;

    @Mixin
    private final SettingOptions unit = new SettingOptions(List.of(MESH_UNIT));

    @Option(
            names = "--output",
            paramLabel = "OUT.obj",
            description = "The file to write. Default: MESH.obj in the current folder.")
    private Path output;

    @Spec
    private CommandSpec specification;

    @Override
    public Integer call() {
        Ending.OBJ.require("--output", output);
        Overwrite overwrite = force.overwrite(output);
        Path target = output != null ? output : Path.of(stem() + ".obj");
        AtomicFile.checkWritable(target, overwrite);
        ReadMesh read = ReadMesh.load(new MeshSource(mesh, unit.choices().get(MESH_UNIT)));
        PrintWriter err = specification.commandLine().getErr();
        read.warnings().forEach(warning -> err.println(Messages.warning(warning)));
        Path written = MeshWriter.write(target, overwrite, read.mesh());
        PrintWriter out = StandardOutput.reports(specification.commandLine().getOut(), err, target);
        out.println(written + ": " + MeshReader.count(read.mesh().vertices(), "vertex") + ", "
                + MeshReader.count(read.mesh().triangles(), "triangle"));
        return ExitCode.OK.code();
    }

    /** The mesh's name without folder and extension. */
    private String stem() {
        String name = String.valueOf(Path.of(mesh).getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
