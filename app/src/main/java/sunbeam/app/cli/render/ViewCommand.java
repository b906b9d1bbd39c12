package sunbeam.app.cli.render;

import java.awt.Dimension;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import sunbeam.app.cli.InspectCommand;
import sunbeam.app.cli.PictureSize;
import sunbeam.app.cli.ReportingCommand;
import sunbeam.app.cli.SettingOptions;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.viewer.Viewer;

/** Command {@code view}: shows a scene in a window. */
@Command(
        name = "view",
        header = "Open the interactive viewer.",
        description = "Show a scene in a window: drag to turn the model, drag with the right button to move the light."
                + " A moving scene is drawn with coarse colors or in few pixels, depending on the method; at rest it"
                + " is refined to the picture that 'render' writes. A scene that names no method is drawn by table at"
                + " tolerance 0.01, whose colors are made the first time and kept; plan.method full in its file, or"
                + " full in the panel, draws without them. F1 lists the mouse and the keys; see also docs/viewer.md.",
        footer = {"  sunbeam view elaphe", "  sunbeam view elaphe --patch scan.png --width 65um --max-height 375nm"})
public final class ViewCommand extends ReportingCommand {
    private static final double SHORTEST_MEASUREMENT = 1;
    private static final double LONGEST_MEASUREMENT = 600;

    @Parameters(
            arity = "0..1",
            paramLabel = "SCENE",
            defaultValue = "close-up",
            description = "A built-in scene or a scene file (.json). Default: ${DEFAULT-VALUE}.")
    private String scene;

    @Option(
            names = "--measure",
            paramLabel = "SECONDS",
            description = "Measure the viewer: wait for the final picture if the method is table, drag the light to"
                    + " and fro, then the model, for 1 to 600 seconds each, print the times of the start's steps,"
                    + " frames per second, the time from input to screen and the difference of the last frame from the"
                    + " final picture, and close. Leave mouse and keyboard alone meanwhile.")
    private Double measure;

    @Option(
            names = "--kiosk",
            description = "For an exhibition with a touch screen: full screen, buttons instead of menus, the caption in"
                    + " large type; after 90 s without a touch the opening scene comes back. Ctrl+Q quits.")
    private boolean kiosk;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description =
                    "Width and height of the picture in the window, in pixels. Default: what a window of 1180x880 leaves for it.")
    private PictureSize size;

    @Mixin
    private final SettingOptions overrides =
            SettingOptions.overriding(SceneOverrides.SETTINGS, SceneOverrides.STANDARDS);

    @Override
    public Integer call() throws InterruptedException {
        UsageException.throwIf(
                measure != null && !(measure >= SHORTEST_MEASUREMENT && measure <= LONGEST_MEASUREMENT),
                "--measure " + measure + " is out of range; give 1 to 600 seconds");
        UsageException.throwIf(
                kiosk && (measure != null || size != null),
                "--kiosk fills the screen and waits for visitors; leave " + (size != null ? "--size" : "--measure")
                        + " out");
        Scene first = SceneOverrides.apply(Scenes.load(scene), overrides.choices());
        Consumer<String> warning = err()::println;
        Dimension pictureSize = size == null ? null : new Dimension(size.width(), size.height());
        if (kiosk) {
            Viewer.showKiosk(first, environment(), warning);
        } else if (measure == null) {
            Viewer.show(first, environment(), warning, pictureSize, InspectCommand::picture);
        } else {
            out().println(Viewer.measure(first, environment(), warning, pictureSize, measure));
        }
        return ExitCode.OK.code();
    }
}
