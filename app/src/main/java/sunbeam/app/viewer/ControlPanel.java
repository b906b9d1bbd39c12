package sunbeam.app.viewer;

import static sunbeam.app.scene.SceneSettings.DIFFRACTION;
import static sunbeam.app.scene.SceneSettings.EXPOSURE;
import static sunbeam.app.scene.SceneSettings.MESH;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.app.scene.SceneSettings.TEXTURE_WEIGHT;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.patch.PatchSettings.PATCH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.SPACING;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** The controls beside the picture. They change the scene and follow it. */
final class ControlPanel extends JPanel {
    private static final String ENTER = "Enter takes it over.";
    private static final String RESET = "Double click resets it.";

    private final transient ViewerModel model;
    private final transient Consumer<String> problem;
    private final NameBox mesh = new NameBox(BuiltInMeshes.names());
    private final NameBox patch = new NameBox(BuiltInPatches.names());
    private final transient Map<String, PatchRequest> loadedPatches = new HashMap<>();
    private final JComboBox<MethodChoice> method = new JComboBox<>(MethodChoice.ALL.toArray(MethodChoice[]::new));
    private final JTextField spacing = new JTextField("1um", 8);
    private JLabel spacingCaption;
    private final JComboBox<String> tolerance = new JComboBox<>(new String[] {"0.05", "0.01", "0.001", "1e-4"});
    private final JTextField coherence = new JTextField(8);
    private final JComboBox<String> average = new JComboBox<>(
            Arrays.stream(Average.values()).map(AVERAGE.kind()::format).toArray(String[]::new));
    private final LabelledSlider rotation;
    private final JCheckBox automatic = new JCheckBox("automatic");
    private final LabelledSlider exposure;
    private final LabelledSlider diffraction;
    private final transient DiffractionWeights weights = new DiffractionWeights();
    private final LabelledSlider texture;
    private boolean updating;
    private double lastExposure = 1;
    private int row;

    ControlPanel(ViewerModel model, Consumer<String> problem) {
        super(new GridBagLayout());
        this.model = model;
        this.problem = problem;
        rotation = new LabelledSlider(
                "rotation",
                -180,
                180,
                Math::toRadians,
                Math::toDegrees,
                value -> format("%.1f", Math.toDegrees(value)),
                ROTATE_PATCH.writtenStandard().orElseThrow(),
                text -> enter(ROTATE_PATCH, text));
        exposure = stops("exposure", -45, 45, EXPOSURE);
        diffraction = stops("diffraction", -15, 60, DIFFRACTION);
        texture = new LabelledSlider(
                "texture",
                0,
                200,
                step -> step / 100,
                weight -> weight * 100,
                weight -> format("%.2f", weight),
                TEXTURE_WEIGHT.writtenStandard().orElseThrow(),
                text -> enter(TEXTURE_WEIGHT, text));
        layOut();
        listen();
    }

    /** @param low in thirds of a stop, as is high: three double the factor */
    private LabelledSlider stops(String name, int low, int high, Setting<?> setting) {
        return new LabelledSlider(
                name,
                low,
                high,
                step -> Math.pow(2, step / 3),
                factor -> 3 * Math.log(Math.max(1e-9, factor)) / Math.log(2),
                factor -> new BigDecimal(factor)
                        .round(new MathContext(3))
                        .stripTrailingZeros()
                        .toPlainString(),
                setting.writtenStandard().orElseThrow(),
                text -> enter(setting, text));
    }

    private void layOut() {
        setBorder(BorderFactory.createEmptyBorder(10, 12, 8, 12));
        add(MESH, mesh, "");
        add(PATCH, patch, "Load others with Ctrl+L or by dropping a file.");
        add(METHOD, method, "");
        spacingCaption = add(SPACING, spacing, ENTER);
        add(TOLERANCE, tolerance, "");
        add(COHERENCE_LENGTH, coherence, ENTER);
        add(AVERAGE, average, "");
        add(ROTATE_PATCH, rotation, RESET);
        add(EXPOSURE, automatic, "Automatic: chosen from the picture.");
        add("", exposure, ControlOrigin.INSTANCE.tip(EXPOSURE, "In thirds of a stop. Double click: automatic."));
        add(DIFFRACTION, diffraction, RESET + " For gem about 0.5.");
        add(TEXTURE_WEIGHT, texture, RESET);
        mesh.setName("mesh");
        patch.setName("patch");
        tolerance.setEditable(true);
        tolerance.setSelectedItem(TOLERANCE.writtenStandard().orElseThrow());
        coherence.setName("coherence");
        method.setName("method");
        spacing.setName("spacing");
    }

    /** @param more what there is to say of the control itself */
    private JLabel add(Setting<?> setting, JComponent control, String more) {
        return add(ControlOrigin.INSTANCE.name(setting), control, ControlOrigin.INSTANCE.tip(setting, more));
    }

    private JLabel add(String caption, JComponent control, String tip) {
        control.setToolTipText(tip);
        JLabel label = new JLabel(caption);
        label.setToolTipText(tip);
        label.setLabelFor(control);
        GridBagConstraints place = new GridBagConstraints();
        place.gridy = row++;
        place.insets = new Insets(3, 0, 3, 8);
        place.anchor = GridBagConstraints.LINE_START;
        add(label, place);
        place.gridx = 1;
        place.weightx = 1;
        place.insets = new Insets(3, 0, 3, 0);
        place.fill = GridBagConstraints.HORIZONTAL;
        add(control, place);
        return label;
    }

    private void listen() {
        onChoice(mesh, name -> enter(MESH, name));
        onChoice(
                patch,
                name -> change(scene -> scene.withPatch(loadedPatches.getOrDefault(name, PatchRequest.of(name)))));
        method.addActionListener(event -> enterMethod());
        spacing.addActionListener(event -> enterMethod());
        onChoice(average, name -> enter(AVERAGE, name));
        onChoice(tolerance, text -> enter(TOLERANCE, text));
        coherence.addActionListener(event -> enter(COHERENCE_LENGTH, coherence.getText()));
        automatic.addActionListener(event -> enter(
                EXPOSURE,
                EXPOSURE.kind()
                        .format(automatic.isSelected() ? OptionalDouble.empty() : OptionalDouble.of(lastExposure))));
    }

    private void onChoice(JComboBox<String> box, Consumer<String> chosen) {
        box.addActionListener(event -> {
            if (!updating && box.getSelectedItem() instanceof String text) {
                chosen.accept(text);
            }
        });
    }

    /** The method, with what other controls say of it. */
    private void enterMethod() {
        MethodChoice choice = (MethodChoice) method.getSelectedItem();
        if (updating || choice == null) {
            return;
        }
        attempt(() -> {
            Choices entered = choice.hasSpacing() ? parsed(SPACING, spacing.getText()) : Choices.none();
            // A method without a tolerance leaves the control as it was.
            Choices all = entered.over(parsed(TOLERANCE, String.valueOf(tolerance.getSelectedItem())));
            change(scene -> weights.follow(scene, scene.withMethod(choice.inPlaceOf(scene.method(), all))));
        });
    }

    /** Takes over what was typed. */
    private void enter(Setting<?> setting, String text) {
        attempt(() -> change(parsed(setting, text)));
    }

    private static Choices parsed(Setting<?> setting, String text) {
        return Choices.at(ControlOrigin.INSTANCE).parsed(setting, text, ControlOrigin.INSTANCE);
    }

    private void change(Choices choices) {
        change(scene -> scene.with(choices));
    }

    /** Changes something; if that cannot be, says so and shows what holds. */
    private void attempt(Runnable change) {
        try {
            change.run();
        } catch (SettingException wrong) {
            problem.accept(wrong.getMessage());
            follow();
        }
    }

    private void change(Function<Scene, Scene> change) {
        if (!updating) {
            model.change(change::apply);
        }
    }

    /** The exposure in use, for a scene that leaves it open: what the slider starts from. */
    void exposureInUse(double factor) {
        lastExposure = factor;
        if (automatic.isSelected()) {
            exposure.follow(factor);
        }
    }

    /** Shows the scene as it is. */
    void follow() {
        updating = true;
        Scene scene = model.scene();
        mesh.select(scene.mesh().name());
        patch.select(scene.patch().patch());
        loadedPatches.put(scene.patch().patch(), scene.patch());
        MethodChoice choice = MethodChoice.of(scene);
        method.setSelectedItem(choice);
        SceneMethod chosen = scene.method();
        chosen.choices()
                .find(SPACING)
                .ifPresent(metres -> show(spacing, SPACING.kind().format(metres)));
        spacing.setVisible(choice.hasSpacing());
        spacingCaption.setVisible(choice.hasSpacing());
        chosen.choices()
                .find(TOLERANCE)
                .ifPresent(error -> tolerance.setSelectedItem(TOLERANCE.kind().format(error)));
        tolerance.setEnabled(choice.hasTolerance());
        average.setEnabled(choice.hasAverages());
        if (!coherence.isFocusOwner()) {
            show(coherence, COHERENCE_LENGTH.kind().format(chosen.get(COHERENCE_LENGTH)));
        }
        average.setSelectedItem(AVERAGE.kind().format(chosen.get(AVERAGE)));
        rotation.follow(scene.rotatePatch());
        automatic.setSelected(scene.exposure().isEmpty());
        scene.exposure().ifPresent(factor -> {
            lastExposure = factor;
            exposure.follow(factor);
        });
        diffraction.follow(scene.blend().diffraction());
        texture.follow(scene.blend().texture());
        updating = false;
    }

    /** A field whose text is set is laid out and painted anew, 60 times a second while a hand moves the light. */
    private static void show(JTextField field, String text) {
        if (!field.getText().equals(text)) {
            field.setText(text);
        }
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
