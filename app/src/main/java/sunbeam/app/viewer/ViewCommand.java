package sunbeam.app.viewer;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import sunbeam.app.cli.Environment;
import sunbeam.app.cli.ExitCode;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scenes;

/** {@code sunbeam view}: the window. */
@Command(
        name = "view",
        header = "Open the interactive viewer.",
        description = "Show a scene in a window: drag to turn the model, drag with the right button to move the light."
                + " While something moves, the picture is a preview; once still, it is refined to what 'render' writes."
                + " F1 lists the mouse and the keys; see also docs/viewer.md.")
public final class ViewCommand implements Callable<Integer> {
    private final Environment environment;

    @Parameters(
            arity = "0..1",
            paramLabel = "SCENE",
            defaultValue = "elaphe",
            description = "A built-in scene or a scene file (.json). Default: ${DEFAULT-VALUE}.")
    private String scene;

    @Spec
    private CommandSpec specification;

    public ViewCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() throws InterruptedException {
        Scene first = Scenes.load(scene);
        PrintWriter err = specification.commandLine().getErr();
        ViewerStart.show(first, environment, line -> {
            err.println(line);
            err.flush();
        });
        return ExitCode.OK.code();
    }
}
