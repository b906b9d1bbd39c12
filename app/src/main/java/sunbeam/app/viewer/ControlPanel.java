package sunbeam.app.viewer;

import static sunbeam.app.scene.SceneSettings.DIFFRACTION;
import static sunbeam.app.scene.SceneSettings.EXPOSURE;
import static sunbeam.app.scene.SceneSettings.GROUND;
import static sunbeam.app.scene.SceneSettings.INDEX;
import static sunbeam.app.scene.SceneSettings.INTENSITY;
import static sunbeam.app.scene.SceneSettings.MESH;
import static sunbeam.app.scene.SceneSettings.MESH_UNIT;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.app.scene.SceneSettings.ROUGHNESS;
import static sunbeam.app.scene.SceneSettings.SCALES;
import static sunbeam.app.scene.SceneSettings.SHADOWS;
import static sunbeam.app.scene.SceneSettings.SKY;
import static sunbeam.app.scene.SceneSettings.TEXTURE;
import static sunbeam.app.scene.SceneSettings.TEXTURE_WEIGHT;
import static sunbeam.app.scene.SceneSettings.TONE;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.patch.PatchSettings.PATCH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.SPACING;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.BorderLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.texture.BodyTextures;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** The controls beside the picture, each of a setting. They change the scene and follow it. */
final class ControlPanel extends JTabbedPane {
    private static final String ENTER = "Enter takes it over.";
    private static final String RESET = "Double click resets it.";
    private static final String NONE = "none";

    private final transient ViewerModel scenes;
    private final transient Consumer<String> problem;
    private final transient Map<String, PatchRequest> loadedPatches = new HashMap<>();
    private final JComboBox<MethodChoice> method = new JComboBox<>(MethodChoice.ALL.toArray(MethodChoice[]::new));
    private final JComboBox<Object> comparison = new JComboBox<>();
    private final JTextField spacing = new JTextField("1um", 8);
    private final JLabel spacingCaption;
    private final NameBox tolerance = new NameBox(List.of("0.05", "0.01", "0.001", "1e-4"));
    private final NameBox average = words(AVERAGE);
    private final JCheckBox automatic = new JCheckBox("automatic");
    private final LabelledSlider exposure = stops(EXPOSURE, -45, 45);
    private final transient DiffractionWeights weights = new DiffractionWeights();
    private final transient List<Consumer<Choices>> followers = new ArrayList<>();
    private boolean updating;
    private double lastExposure = 1;

    ControlPanel(ViewerModel scenes, Consumer<String> problem) {
        this.scenes = scenes;
        this.problem = problem;
        JPanel color = tab("Color");
        NameBox patch = new NameBox(BuiltInPatches.names());
        row(color, PATCH, patch, "Load others with Ctrl+L or by dropping a file.");
        onChoice(
                patch,
                name -> change(scene -> scene.withPatch(loadedPatches.getOrDefault(name, PatchRequest.of(name)))));
        followers.add(choices -> patch.select(scenes.scene().patch().patch()));
        row(color, METHOD, method, "");
        method.addActionListener(event -> enterMethod());
        comparison.addItem("off");
        MethodChoice.COMPARED.forEach(comparison::addItem);
        comparison.setName("comparison");
        row(
                color,
                "Beside it",
                comparison,
                "Draws the same view by another method, to the right of a line that can be dragged.");
        spacingCaption = row(color, SPACING, spacing, ENTER);
        spacing.addActionListener(event -> enterMethod());
        tolerance.setSelectedItem(TOLERANCE.writtenStandard().orElseThrow());
        box(color, TOLERANCE, tolerance, true);
        text(color, COHERENCE_LENGTH);
        box(color, AVERAGE, average, false);
        slider(
                color,
                ROTATE_PATCH,
                slider(ROTATE_PATCH, -180, 180, Math::toRadians, Math::toDegrees, ControlPanel::degrees));
        text(color, INDEX);
        row(color, EXPOSURE, automatic, "Automatic: chosen from the picture.");
        automatic.addActionListener(event -> enter(
                EXPOSURE,
                EXPOSURE.kind()
                        .format(automatic.isSelected() ? OptionalDouble.empty() : OptionalDouble.of(lastExposure))));
        row(color, "", exposure, ControlOrigin.INSTANCE.tip(EXPOSURE, "In thirds of a stop. Double click: automatic."));
        followers.add(this::followExposure);
        slider(color, DIFFRACTION, stops(DIFFRACTION, -15, 60));
        JPanel scene = tab("Scene");
        box(scene, MESH, new NameBox(BuiltInMeshes.names()), false);
        box(scene, MESH_UNIT, words(MESH_UNIT), false);
        box(scene, TEXTURE, new NameBox(BodyTextures.names()), false);
        slider(scene, TEXTURE_WEIGHT, hundredths(TEXTURE_WEIGHT, 200));
        box(scene, SCALES, words(SCALES), false);
        slider(
                scene,
                ROUGHNESS,
                slider(
                        ROUGHNESS,
                        0,
                        100,
                        step -> Math.toRadians(step / 10),
                        angle -> 10 * Math.toDegrees(angle),
                        ControlPanel::degrees));
        slider(scene, INTENSITY, stops(INTENSITY, -15, 15));
        box(scene, GROUND, new NameBox(List.of(NONE, "#3a3733", "#808080", "#d8d2c8")), true);
        slider(scene, SKY, hundredths(SKY, 200));
        flag(scene, SHADOWS);
        box(scene, TONE, words(TONE), false);
    }

    private JPanel tab(String title) {
        JPanel rows = new JPanel(new GridBagLayout());
        rows.setBorder(BorderFactory.createEmptyBorder(6, 12, 6, 12));
        JPanel top = new JPanel(new BorderLayout());
        top.add(rows, BorderLayout.NORTH);
        addTab(title, top);
        return rows;
    }

    /** The words that a setting may have. */
    private static NameBox words(Setting<?> setting) {
        return new NameBox(List.of(setting.kind().range().split(", ")));
    }

    /** A choice; one that may be typed, too. */
    private void box(JPanel tab, Setting<?> setting, NameBox box, boolean isEditable) {
        box.setEditable(isEditable);
        row(tab, setting, box, isEditable ? ENTER : "");
        onChoice(box, text -> enter(setting, text));
        followers.add(choices -> {
            // A method without the setting leaves its control as it was.
            if (choices.has(setting)) {
                box.select(choices.written(setting));
            }
        });
    }

    private void text(JPanel tab, Setting<?> setting) {
        JTextField field = new JTextField(8);
        row(tab, setting, field, ENTER);
        field.addActionListener(event -> enter(setting, field.getText()));
        followers.add(choices -> {
            if (!field.isFocusOwner()) {
                show(field, choices.orStandard(setting).written(setting));
            }
        });
    }

    private void flag(JPanel tab, Setting<Boolean> setting) {
        JCheckBox box = new JCheckBox();
        row(tab, setting, box, "");
        box.addActionListener(event -> enter(setting, String.valueOf(box.isSelected())));
        followers.add(choices -> box.setSelected(choices.get(setting)));
    }

    private void slider(JPanel tab, Setting<Double> setting, LabelledSlider slider) {
        row(tab, setting, slider, RESET);
        followers.add(choices -> slider.follow(choices.get(setting)));
    }

    private LabelledSlider slider(
            Setting<?> setting,
            int low,
            int high,
            DoubleUnaryOperator fromSlider,
            DoubleUnaryOperator toSlider,
            DoubleFunction<String> text) {
        return new LabelledSlider(
                setting.key(),
                low,
                high,
                fromSlider,
                toSlider,
                text,
                setting.writtenStandard().orElseThrow(),
                entered -> enter(setting, entered));
    }

    private LabelledSlider hundredths(Setting<?> setting, int high) {
        return slider(setting, 0, high, step -> step / 100, weight -> weight * 100, weight -> format("%.2f", weight));
    }

    /** @param low in thirds of a stop, as is high: three double the factor */
    private LabelledSlider stops(Setting<?> setting, int low, int high) {
        return slider(
                setting,
                low,
                high,
                step -> Math.pow(2, step / 3),
                factor -> 3 * Math.log(Math.max(1e-9, factor)) / Math.log(2),
                factor -> new BigDecimal(factor)
                        .round(new MathContext(3))
                        .stripTrailingZeros()
                        .toPlainString());
    }

    private static String degrees(double angle) {
        return format("%.1f", Math.toDegrees(angle));
    }

    /** @param more what there is to say of the control itself */
    private static JLabel row(JPanel tab, Setting<?> setting, JComponent control, String more) {
        control.setName(setting.key());
        return row(tab, ControlOrigin.INSTANCE.name(setting), control, ControlOrigin.INSTANCE.tip(setting, more));
    }

    private static JLabel row(JPanel tab, String caption, JComponent control, String tip) {
        control.setToolTipText(tip);
        JLabel label = new JLabel(caption);
        label.setToolTipText(tip);
        label.setLabelFor(control);
        GridBagConstraints place = new GridBagConstraints();
        place.gridy = tab.getComponentCount() / 2;
        place.insets = new Insets(3, 0, 3, 8);
        place.anchor = GridBagConstraints.LINE_START;
        tab.add(label, place);
        place.gridx = 1;
        place.weightx = 1;
        place.insets = new Insets(3, 0, 3, 0);
        place.fill = GridBagConstraints.HORIZONTAL;
        tab.add(control, place);
        return label;
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
        if (!updating && choice != null) {
            attempt(() -> change(scene -> by(choice, scene)));
        }
    }

    private Scene by(MethodChoice choice, Scene scene) {
        Choices entered = choice.hasSpacing() ? parsed(SPACING, spacing.getText()) : Choices.none();
        // A method without a tolerance leaves the control as it was.
        Choices all = entered.over(parsed(TOLERANCE, String.valueOf(tolerance.getSelectedItem())));
        return weights.follow(scene, scene.withMethod(choice.inPlaceOf(scene.method(), all)));
    }

    /** Hears that another method is to be drawn beside the scene's own. */
    void onComparison(Runnable chosen) {
        comparison.addActionListener(event -> chosen.run());
    }

    /** The scene by the method that is drawn beside its own; empty where none is, and where that is its own. */
    Optional<Scene> compared(Scene scene) {
        return comparison.getSelectedItem() instanceof MethodChoice choice && !choice.equals(MethodChoice.of(scene))
                ? Optional.of(by(choice, scene))
                : Optional.empty();
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
            scenes.change(change::apply);
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
        Scene scene = scenes.scene();
        loadedPatches.put(scene.patch().patch(), scene.patch());
        Choices choices = scene.choices().orStandard(AVERAGE);
        followers.forEach(follower -> follower.accept(choices));
        MethodChoice choice = MethodChoice.of(scene);
        method.setSelectedItem(choice);
        if (choices.has(SPACING)) {
            show(spacing, choices.written(SPACING));
        }
        spacing.setVisible(choice.hasSpacing());
        spacingCaption.setVisible(choice.hasSpacing());
        tolerance.setEnabled(choice.hasTolerance());
        average.setEnabled(choice.hasAverages());
        updating = false;
    }

    private void followExposure(Choices choices) {
        OptionalDouble chosen = choices.get(EXPOSURE);
        automatic.setSelected(chosen.isEmpty());
        chosen.ifPresent(factor -> {
            lastExposure = factor;
            exposure.follow(factor);
        });
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
