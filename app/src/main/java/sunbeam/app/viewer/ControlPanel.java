package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.viewer.SettingRows.NameBox;
import sunbeam.app.viewer.SettingRows.Scale;
import sunbeam.app.viewer.SettingRows.ValueSlider;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.setting.ValueKind;

/** Panel of controls beside the picture. Each changes one setting of the scene and shows its current value. */
public final class ControlPanel extends JTabbedPane {
    private static final double WEIGHT_WITHOUT_MIRROR = 0.5;

    private final transient ViewerModel scenes;
    private final StatusLine status;
    private final transient Map<String, PatchRequest> loadedPatches = new HashMap<>();
    private final JComboBox<MethodChoice> method = new JComboBox<>(MethodChoice.ALL.toArray(MethodChoice[]::new));
    public final JComboBox<Object> comparison = new JComboBox<>();
    private final JTextField spacing = new JTextField("1um", 8);
    private final JLabel patchCaption;
    private final String patchTip;
    private final JLabel spacingCaption;
    private final NameBox tolerance = new NameBox(List.of("0.05", "0.01", "0.001", "1e-4"));
    private final NameBox average = SettingRows.words(MethodSettings.AVERAGE);
    private final JCheckBox automatic = new JCheckBox("automatic");
    private final SettingRows colorTab = new SettingRows(this::enter);
    private final SettingRows sceneTab = new SettingRows(this::enter);
    private final ValueSlider exposure = colorTab.new ValueSlider(SceneSettings.EXPOSURE, Scale.STOPS, -45, 45);
    private transient MethodPlan plan;
    private transient List<String> remarks = List.of();
    // Weight of diffracted light of the last method with power relative to a mirror's peak; empty before another one.
    private OptionalDouble weightByMirror = OptionalDouble.empty();
    private boolean updating;
    // Message about the last value that could not be used.
    private String refusal = "";
    private double lastExposure = 1;

    ControlPanel(ViewerModel scenes, StatusLine status) {
        this.scenes = scenes;
        this.status = status;
        NameBox patch = new NameBox(BuiltInPatches.names());
        patchCaption = colorTab.row(PatchSettings.PATCH, patch, "Load others with Ctrl+L or by dropping a file.");
        patchTip = patchCaption.getToolTipText();
        patchCaption.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                status.message(String.join("\n", remarks));
            }
        });
        SettingRows.onChoice(
                patch,
                name -> change(scene -> scene.withPatch(loadedPatches.getOrDefault(name, PatchRequest.of(name)))));
        colorTab.onFollow(choices -> patch.select(scenes.scene().patch().patch()));
        colorTab.row(Methods.METHOD, method, "");
        method.addActionListener(event -> enterMethod());
        comparison.addItem("off");
        MethodChoice.COMPARED.forEach(comparison::addItem);
        comparison.setName("comparison");
        colorTab.row(
                "Beside it",
                comparison,
                "Draws the same view by another method, to the right of a line that can be dragged. The thesis's preset shows CIE RGB primaries, whose white is bluish.");
        spacingCaption = colorTab.row(MethodSettings.SPACING, spacing, SettingRows.ENTER);
        spacing.addActionListener(event -> enterMethod());
        tolerance.setSelectedItem(MethodSettings.TOLERANCE.writtenStandard().orElseThrow());
        colorTab.box(MethodSettings.TOLERANCE, tolerance, true);
        colorTab.text(MethodSettings.COHERENCE_LENGTH);
        colorTab.box(MethodSettings.AVERAGE, average, false);
        colorTab.slider(SceneSettings.ROTATE_PATCH, Scale.DEGREES, -180, 180);
        colorTab.text(SceneSettings.INDEX);
        colorTab.box(SceneSettings.ENERGY, SettingRows.words(SceneSettings.ENERGY), false);
        JButton meter = new JButton("Meter");
        meter.setName("meter");
        meter.setToolTipText("Makes the exposure automatic and measures it under the present light.");
        meter.addActionListener(event -> scenes.meter());
        Box metering = Box.createHorizontalBox();
        metering.add(automatic);
        metering.add(Box.createHorizontalGlue());
        metering.add(meter);
        colorTab.row(
                SceneSettings.EXPOSURE, metering, "Automatic: measured once, kept while light, model and camera move.");
        automatic.setToolTipText(metering.getToolTipText());
        automatic.setName(metering.getName());
        automatic.addActionListener(event -> enter(
                SceneSettings.EXPOSURE,
                SceneSettings.EXPOSURE
                        .kind()
                        .format(automatic.isSelected() ? OptionalDouble.empty() : OptionalDouble.of(lastExposure))));
        colorTab.row(
                "",
                exposure,
                ControlOrigin.INSTANCE.tip(SceneSettings.EXPOSURE, "In thirds of a stop. Double click: automatic."));
        colorTab.onFollow(this::followExposure);
        colorTab.slider(SceneSettings.DIFFRACTION, Scale.STOPS, -15, 60);
        addScene();
        addTab("Color", onTop(colorTab));
        addTab("Scene", onTop(sceneTab));
    }

    private void addScene() {
        sceneTab.box(SceneSettings.MESH, new NameBox(BuiltInMeshes.names()), false);
        sceneTab.box(SceneSettings.MESH_UNIT, SettingRows.words(SceneSettings.MESH_UNIT), false);
        sceneTab.box(SceneSettings.TEXTURE, new NameBox(BodyTexture.names()), false);
        sceneTab.slider(SceneSettings.TEXTURE_WEIGHT, Scale.HUNDREDTHS, 0, 200);
        sceneTab.box(SceneSettings.SCALES, SettingRows.words(SceneSettings.SCALES), false);
        sceneTab.slider(SceneSettings.ROUGHNESS, Scale.TENTHS_OF_DEGREES, 0, 100);
        sceneTab.slider(SceneSettings.INTENSITY, Scale.STOPS, -15, 15);
        sceneTab.slider(SceneSettings.ANGULAR_DIAMETER, Scale.TENTHS_OF_DEGREES, 0, 150);
        sceneTab.box(SceneSettings.GROUND, new NameBox(List.of("none", "#3a3733", "#808080", "#d8d2c8")), true);
        sceneTab.slider(SceneSettings.SKY, Scale.HUNDREDTHS, 0, 200);
        sceneTab.box(SceneSettings.ENVIRONMENT, new NameBox(SceneSettings.environments()), false);
        sceneTab.slider(SceneSettings.ENVIRONMENT_INTENSITY, Scale.STOPS, -15, 15);
        sceneTab.flag(SceneSettings.SHADOWS);
        sceneTab.box(SceneSettings.TONE, SettingRows.words(SceneSettings.TONE), false);
    }

    private static JPanel onTop(SettingRows rows) {
        JPanel top = new JPanel(new BorderLayout());
        top.add(rows, BorderLayout.NORTH);
        return top;
    }

    private void enterMethod() {
        MethodChoice choice = (MethodChoice) method.getSelectedItem();
        if (choice != null) {
            change(scene -> by(choice, scene));
        }
    }

    private Scene by(MethodChoice choice, Scene scene) {
        Choices entered =
                choice.has(MethodSettings.SPACING) ? parsed(MethodSettings.SPACING, spacing.getText()) : Choices.none();
        if (choice.hasTolerance()) {
            // The control keeps its tolerance while the scene's method has none, so take it from the control.
            entered = entered.over(parsed(MethodSettings.TOLERANCE, String.valueOf(tolerance.getSelectedItem())));
        }
        return reweighted(scene, scene.withMethod(choice.inPlaceOf(scene.method(), entered)));
    }

    /**
     * Sets the weight of diffracted light that suits the method. Most give power relative to a mirror's peak, so that a skin needs weights
     * of 1e4 and more; {@code gem} does not and would be white with such a weight.
     */
    private Scene reweighted(Scene before, Scene after) {
        boolean was = before.method().method().isNormalizedToMirror();
        boolean is = after.method().method().isNormalizedToMirror();
        if (was && !is) {
            weightByMirror = OptionalDouble.of(before.get(SceneSettings.DIFFRACTION));
            return after.with(SceneSettings.DIFFRACTION, WEIGHT_WITHOUT_MIRROR);
        }
        return is && !was && weightByMirror.isPresent()
                ? after.with(SceneSettings.DIFFRACTION, weightByMirror.getAsDouble())
                : after;
    }

    /** Returns the scene by the comparison method; empty if none or the scene's own is chosen. */
    public Optional<Scene> compared(Scene scene) {
        return comparison.getSelectedItem() instanceof MethodChoice choice && !choice.equals(MethodChoice.of(scene))
                ? Optional.of(by(choice, scene))
                : Optional.empty();
    }

    private void enter(Setting<?> setting, String text) {
        change(scene -> scene.with(parsed(setting, text)));
    }

    private static Choices parsed(Setting<?> setting, String text) {
        return Choices.at(ControlOrigin.INSTANCE).parsed(setting, text, ControlOrigin.INSTANCE);
    }

    private void change(UnaryOperator<Scene> change) {
        if (updating) {
            return;
        }
        try {
            scenes.change(change);
            status.withdraw(refusal);
        } catch (SettingException wrong) {
            refusal = wrong.getMessage();
            status.message(refusal);
            follow();
        }
    }

    /** The slider starts from the exposure of the picture when automatic exposure is switched off. */
    public void exposureInUse(double factor) {
        lastExposure = factor;
        if (automatic.isSelected()) {
            exposure.follow(factor);
        }
    }

    public void follow() {
        updating = true;
        Scene shown = scenes.scene();
        loadedPatches.put(shown.patch().patch(), shown.patch());
        Choices choices = shown.choices().orStandard(MethodSettings.AVERAGE);
        colorTab.follow(choices);
        sceneTab.follow(choices);
        MethodChoice choice = MethodChoice.of(shown);
        method.setSelectedItem(choice);
        if (choices.has(MethodSettings.SPACING)) {
            SettingRows.show(spacing, choices.written(MethodSettings.SPACING));
        }
        spacing.setVisible(choice.has(MethodSettings.SPACING));
        spacingCaption.setVisible(choice.has(MethodSettings.SPACING));
        tolerance.setEnabled(choice.hasTolerance());
        average.setEnabled(choice.has(MethodSettings.AVERAGE));
        scenes.loaded().ifPresent(this::followRemarks);
        updating = false;
    }

    /** Marks the patch's caption if there are remarks about it: as tooltip, and by a click as message. */
    private void followRemarks(LoadedScene loaded) {
        if (SceneSharing.isSame(loaded.firstPart().method(), plan)) {
            return;
        }
        plan = loaded.firstPart().method();
        remarks = loaded.parts().stream()
                .flatMap(part -> SceneData.patchRemarks(part.scene(), part.patch()).stream())
                .distinct()
                .toList();
        patchCaption.setText(ControlOrigin.INSTANCE.name(PatchSettings.PATCH) + (remarks.isEmpty() ? "" : " (i)"));
        patchCaption.setToolTipText(
                remarks.isEmpty()
                        ? patchTip
                        : ControlOrigin.wrapped(String.join("\n", remarks)).replace("\n", "<br>"));
    }

    private void followExposure(Choices choices) {
        OptionalDouble chosen = choices.get(SceneSettings.EXPOSURE);
        automatic.setSelected(chosen.isEmpty());
        chosen.ifPresent(factor -> {
            lastExposure = factor;
            exposure.follow(factor);
        });
    }

    /** ChoiceOrigin of choices made by the window's controls; names a setting by its control's caption. */
    public enum ControlOrigin implements ChoiceOrigin {
        INSTANCE;

        // Captions of settings whose key, split into words, would be too long or too vague.
        private static final Map<Setting<?>, String> CAPTIONS = Map.of(
                MethodSettings.COHERENCE_LENGTH, "Coherence",
                MethodSettings.SPACING, "Lines",
                PatchSettings.MAX_HEIGHT, "Height of full scale",
                SceneSettings.ROTATE_PATCH, "Rotation",
                SceneSettings.DIFFRACTION, "Diffraction",
                SceneSettings.INTENSITY, "Light",
                SceneSettings.TEXTURE_WEIGHT, "Texture's weight",
                SceneSettings.INDEX, "Refractive index");

        @Override
        public Place place() {
            return Place.CONTROL;
        }

        @Override
        public String name(Setting<?> setting) {
            String words = setting.words(" ");
            return CAPTIONS.getOrDefault(setting, words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1));
        }

        /** Returns a control's tooltip: effect, unit and limits of the setting, then {@code more}, a text about the control. */
        public String tip(Setting<?> setting, String more) {
            ValueKind<?> kind = setting.kind();
            String unit = kind.form() == ValueKind.Form.QUANTITY ? "With its unit" : "Without unit";
            String values = kind.form() == ValueKind.Form.TEXT ? "No unit." : unit + ", " + kind.range() + ".";
            return wrapped(String.join(" ", setting.help().in(this), values, more));
        }

        static String wrapped(String text) {
            return "<html><body style='width: 260px'>"
                    + text.replace("&", "&amp;").replace("<", "&lt;").strip();
        }
    }
}
