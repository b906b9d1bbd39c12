package sunbeam.app.viewer;

import java.awt.GridLayout;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;
import javax.swing.filechooser.FileNameExtensionFilter;
import jrtr.VertexData.BoundingSphere;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.render.FrameText;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.terminal.Environment;
import sunbeam.app.viewer.ControlPanel.ControlOrigin;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.loop.Stage;
import sunbeam.app.viewer.loop.ViewState;
import sunbeam.app.viewer.model.Drags;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** Actions that load and save files, off the event thread. */
public final class FileActions {
    public enum Kind {
        SCENE("scene", "json"),
        PATCH(
                "patch (descriptor, image or scan)",
                "json png jpg jpeg bmp gif tif tiff gwy gsf spm 000 di jpk ibw nid stp top mi sdf x3p sur bcr bcrf opd dat plu al3d vk3 vk4 npy txt csv asc xyz"),
        MESH("mesh", "obj ply glb gltf"),
        TEXTURE("texture", "png jpg jpeg bmp gif"),
        PICTURE("picture", "png");

        private final String words;
        private final String endings;

        Kind(String words, String endings) {
            this.words = words;
            this.endings = endings;
        }

        private List<String> endings() {
            return List.of(endings.split(" ", -1));
        }

        FileNameExtensionFilter filter() {
            String first = endings().stream().limit(4).collect(Collectors.joining(", ."));
            String more = endings().size() > 4 ? ", ..." : "";
            return new FileNameExtensionFilter(words + " (." + first + more + ")", endings.split(" ", -1));
        }
    }

    private final Viewer viewer;
    private final ViewerWindow window;
    private final ViewerModel model;
    final RecentFiles recent;
    private Path folder = Path.of("").toAbsolutePath();
    private Path pictureWaiting;

    FileActions(Viewer viewer, RecentFiles recent) {
        this.viewer = viewer;
        this.recent = recent;
        window = viewer.window;
        model = viewer.model;
        window.getRootPane().setTransferHandler(new Drop());
    }

    public void load(Kind kind) {
        ask(kind, JFileChooser.OPEN_DIALOG).ifPresent(file -> load(kind, file));
    }

    private void load(Kind kind, Path file) {
        if (kind != Kind.TEXTURE) {
            run(Executors.callable(() -> recent.add(file)), added -> {});
        }
        switch (kind) {
            case SCENE ->
                run(
                        () -> Scenes.read(file),
                        scene -> viewer.open(scene, () -> window.status.message("loaded " + file.getFileName())));
            case MESH ->
                model.open(
                        model.scene()
                                .withMesh(MeshSource.of(file.toAbsolutePath().toString())),
                        this::frameMesh);
            case TEXTURE -> model.change(scene -> scene.with(SceneSettings.TEXTURE, file.toString()));
            case PATCH, PICTURE -> loadPatch(file);
        }
    }

    private void frameMesh() {
        BoundingSphere bounds = model.loaded().orElseThrow().firstPart().shape().bounds();
        model.amend(scene -> Drags.framed(scene, bounds));
    }

    /** Loads a scene, mesh or patch, by name (meshes) or content. */
    public void load(Path file) {
        if (MeshSource.isFile(file)) {
            load(Kind.MESH, file);
            return;
        }
        run(() -> Scenes.isScene(file), isScene -> load(isScene ? Kind.SCENE : Kind.PATCH, file));
    }

    public void loadPatch(Path file) {
        if (!Files.exists(file)) {
            window.status.message("cannot load " + file + ": there is no such file");
            return;
        }
        Choices named = Choices.at(ControlOrigin.INSTANCE)
                .with(PatchSettings.PATCH, file.toAbsolutePath().toString());
        boolean hasScales = file.toString().toLowerCase(Locale.ROOT).endsWith(".json") || PatchLoader.isScan(file);
        (hasScales ? Optional.of(named) : askForScales(file, named)).ifPresent(choices -> {
            viewer.inspections.awaitPatch();
            model.change(scene -> scene.withOwnPatch(new PatchRequest(choices)));
        });
    }

    /** Adds the scales of an image, which a dialog asks for until they can be used; empty if the user cancels it. */
    private Optional<Choices> askForScales(Path file, Choices named) {
        JPanel form = new JPanel(new GridLayout(2, 2, 8, 6));
        JTextField width = field(form, PatchSettings.WIDTH, ", such as 65 um");
        JTextField maxHeight = field(form, PatchSettings.MAX_HEIGHT, ", such as 375 nm");
        String problem = "";
        while (confirms(form, problem, width, "Scale of " + file.getFileName())) {
            try {
                return Optional.of(named.parsed(PatchSettings.WIDTH, width.getText(), ControlOrigin.INSTANCE)
                        .parsed(PatchSettings.MAX_HEIGHT, maxHeight.getText(), ControlOrigin.INSTANCE));
            } catch (SettingException wrong) {
                problem = wrong.getMessage();
            }
        }
        return Optional.empty();
    }

    private boolean confirms(Object question, String title, int type) {
        int answer = JOptionPane.showConfirmDialog(window, question, title, JOptionPane.OK_CANCEL_OPTION, type);
        return answer == JOptionPane.OK_OPTION;
    }

    /** Asks with the focus on a field, so that typing answers; Enter confirms. */
    private boolean confirms(JPanel form, String problem, JTextField first, String title) {
        JOptionPane pane =
                new JOptionPane(new Object[] {form, problem}, JOptionPane.PLAIN_MESSAGE, JOptionPane.OK_CANCEL_OPTION) {
                    @Override
                    public void selectInitialValue() {
                        super.selectInitialValue(); // makes OK the button of Enter
                        first.requestFocusInWindow();
                    }
                };
        JDialog dialog = pane.createDialog(window, title);
        dialog.setVisible(true);
        dialog.dispose();
        return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue());
    }

    private static JTextField field(JPanel form, Setting<Double> setting, String example) {
        JTextField field = new JTextField(10);
        field.setToolTipText(ControlOrigin.INSTANCE.tip(setting, ""));
        form.add(new JLabel(ControlOrigin.INSTANCE.name(setting) + example));
        form.add(field);
        return field;
    }

    public void saveScene() {
        Scene scene = model.scene();
        ask(Kind.SCENE, JFileChooser.SAVE_DIALOG)
                .ifPresent(file -> save(file, () -> SceneWriter.write(file, Overwrite.REPLACE, scene)));
    }

    public void savePicture() {
        ask(Kind.PICTURE, JFileChooser.SAVE_DIALOG).ifPresent(this::savePicture);
    }

    public void savePicture(Path file) {
        pictureWaiting = file;
        window.status.message("the picture is saved once it is final");
        writeWaiting();
    }

    void writeWaiting() {
        RenderLoop.Finished finished = viewer.presenter.finished().orElse(null);
        if (pictureWaiting == null || finished == null) {
            return;
        }
        Path file = pictureWaiting;
        pictureWaiting = null;
        ViewState state = finished.state();
        String renderer = viewer.presenter.renderer;
        save(file, () -> {
            Stage.Final picture = finished.picture();
            Scene scene = state.firstPart().scene();
            PixelSamples samples = PixelSamples.inWindow(scene.method(), state.width(), state.height());
            FrameText text = new FrameText(state.scene().parts(), state.width(), state.height(), samples, "");
            PngWriter.write(file, Overwrite.REPLACE, picture.image(), text.of(scene, picture.exposure(), renderer));
        });
    }

    private void save(Path file, Runnable writing) {
        run(Executors.callable(writing), done -> window.status.message("saved " + file));
    }

    private <T> void run(Callable<T> work, Consumer<T> done) {
        viewer.writing.run(work, done, window.status::message);
    }

    private Optional<Path> ask(Kind kind, int dialog) {
        boolean saves = dialog == JFileChooser.SAVE_DIALOG;
        JFileChooser chooser = new JFileChooser(folder.toFile());
        chooser.setDialogTitle((saves ? "Save " : "Load ") + kind.words);
        chooser.setDialogType(dialog);
        chooser.setFileFilter(kind.filter());
        if (chooser.showDialog(window, saves ? "Save" : "Load") != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        Path file = chooser.getSelectedFile().toPath().toAbsolutePath();
        folder = file.getParent();
        String name = file.getFileName().toString();
        Path target = saves && !name.contains(".")
                ? file.resolveSibling(name + "." + kind.endings().get(0))
                : file;
        String question = target.getFileName() + " exists. Replace it?";
        boolean mayUse =
                !saves || !Files.exists(target) || confirms(question, "Replace file", JOptionPane.QUESTION_MESSAGE);
        return mayUse ? Optional.of(target) : Optional.empty();
    }

    private final class Drop extends TransferHandler {
        @Override
        public boolean canImport(TransferSupport support) {
            if (support.isDrop()) {
                if ((support.getSourceDropActions() & COPY) == 0) {
                    return false;
                }
                // Force a copy: a source that moves files would delete the file afterwards.
                support.setDropAction(COPY);
            }
            return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
        }

        @Override
        public boolean importData(TransferSupport support) {
            try {
                Object data = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
                if (data instanceof List<?> files && !files.isEmpty() && files.get(0) instanceof File file) {
                    // The drag's source waits for this method, and loading may open a dialog.
                    SwingUtilities.invokeLater(() -> load(file.toPath()));
                    return true;
                }
            } catch (UnsupportedFlavorException | IOException failure) {
                window.status.message("the dropped file cannot be read: " + failure.getMessage());
            }
            return false;
        }
    }

    /**
     * Files that the user loaded last, one a line in {@code $XDG_STATE_HOME/sunbeam/recent-files}, else {@code
     * ~/.local/state/sunbeam/recent-files} (XDG Base Directory Specification 0.8).
     */
    public record RecentFiles(Path list) {
        private static final int MOST = 8;
        private static final long LONGEST_LIST_BYTES = 1 << 16;

        public static RecentFiles of(Environment environment) {
            String state = environment.variable("XDG_STATE_HOME");
            Path base =
                    state.startsWith("/") ? Path.of(state) : environment.home().resolve(".local/state");
            return new RecentFiles(base.resolve("sunbeam/recent-files"));
        }

        /** Returns the files that are still there, the last one first; none if the list cannot be read. */
        public List<Path> files() {
            try {
                return !Files.isRegularFile(list) || Files.size(list) > LONGEST_LIST_BYTES
                        ? List.of()
                        : Files.readAllLines(list).stream()
                                .map(Path::of)
                                .filter(file -> file.isAbsolute() && Files.isRegularFile(file))
                                .limit(MOST)
                                .toList();
            } catch (IOException | InvalidPathException damaged) {
                return List.of();
            }
        }

        void add(Path file) {
            List<Path> files = new ArrayList<>(files());
            files.remove(file.toAbsolutePath());
            files.add(0, file.toAbsolutePath());
            OutputFolder.createWithParents(list.getParent());
            String lines = String.join(
                    "\n", files.stream().limit(MOST).map(Path::toString).toList());
            AtomicFile.write(list, Overwrite.REPLACE, StreamContent.of(lines));
        }
    }
}
