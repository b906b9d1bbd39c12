package sunbeam.app.viewer;

import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import sunbeam.app.mesh.BuiltInMeshes;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.LengthFormatException;
import sunbeam.precompute.units.Lengths;

/** The controls beside the picture. They change the scene and follow it. */
final class ControlPanel extends JPanel {
    private static final double SHORTEST = 100e-9;
    private static final double LONGEST = 10e-3;

    private final transient ViewerModel model;
    private final transient Consumer<String> problem;
    private final NameBox mesh = new NameBox(BuiltInMeshes.names());
    private final NameBox patch = new NameBox(BuiltInPatches.names());
    private final transient Map<String, PatchRequest> loadedPatches = new HashMap<>();
    private final JComboBox<MethodChoice> method = new JComboBox<>(MethodChoice.values());
    private final JTextField spacing = new JTextField("1um", 8);
    private JLabel spacingCaption;
    private final JComboBox<String> tolerance = new JComboBox<>(new String[] {"0.05", "0.01", "0.001", "1e-4"});
    private final JTextField coherence = new JTextField(8);
    private final JComboBox<String> average = new JComboBox<>(new String[] {"coherent", "ensemble"});
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
                value -> format("%.0f°", Math.toDegrees(value)),
                value -> change(scene -> scene.withRotatePatch(value)));
        exposure = stops("exposure", -60, 60, value -> change(scene -> scene.withExposure(OptionalDouble.of(value))));
        diffraction = stops("diffraction", -20, 80, value -> blend(old -> old.withDiffraction(value)));
        texture = new LabelledSlider(
                "texture",
                0,
                200,
                step -> step / 100,
                weight -> weight * 100,
                weight -> format("%.2f", weight),
                value -> blend(old -> new Blend(old.diffraction(), value, old.diffuse(), old.ambient())));
        layOut();
        listen();
    }

    /** @param low in quarters of a stop, as is high: four double the factor */
    private static LabelledSlider stops(String name, int low, int high, DoubleConsumer changed) {
        return new LabelledSlider(
                name,
                low,
                high,
                step -> Math.pow(2, step / 4),
                factor -> 4 * Math.log(Math.max(1e-9, factor)) / Math.log(2),
                factor -> format("%.3g", factor),
                changed);
    }

    private void layOut() {
        setBorder(BorderFactory.createEmptyBorder(10, 12, 8, 12));
        add("Mesh", mesh, "The body that carries the nanostructure; no unit");
        add("Patch", patch, "The nanostructure's height map; no unit. Load others with Ctrl+L or by dropping a file");
        add(
                "Method",
                method,
                "full: all wavelengths; nmm: one per order; pq: replicas with sharp edges; gem: lines alone. thesis: 37"
                        + " Taylor terms, 5 nm. No unit; see docs/methods.md");
        spacingCaption = add(
                "Lines",
                spacing,
                "For gem: distance of the grating's lines, a length such as 1um; Enter takes it over");
        add(
                "Tolerance",
                tolerance,
                "Relative error of power and colour that the final picture is planned for, no unit");
        add(
                "Coherence",
                coherence,
                "Coherence length of the light, a length such as 65um (m, mm, um, nm); Enter takes it over");
        add("Average", average, "One coherence area with its speckle, or the mean over all of them; no unit");
        add("Rotation", rotation, "Turns the nanostructure in the tangent plane, degrees");
        add("Exposure", automatic, "Chooses the factor from the picture; no unit");
        add("", exposure, "Factor of the linear colours, no unit; a step of 4 doubles it");
        add(
                "Diffraction",
                diffraction,
                "Weight of the diffracted light, a factor without unit; a step of 4 doubles it. For gem about 0.5");
        add("Texture", texture, "Weight of the body's texture, a factor without unit");
        mesh.setName("mesh");
        patch.setName("patch");
        tolerance.setEditable(true);
        coherence.setName("coherence");
        method.setName("method");
        spacing.setName("spacing");
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
        onChoice(mesh, name -> change(scene -> scene.withMesh(name)));
        onChoice(
                patch,
                name -> change(scene -> scene.withPatch(loadedPatches.getOrDefault(name, PatchRequest.of(name)))));
        method.addActionListener(event -> enterMethod());
        spacing.addActionListener(event -> enterMethod());
        onChoice(
                average,
                name -> plan(
                        old -> PlanChange.average(old, name.equals("coherent") ? Average.COHERENT : Average.ENSEMBLE)));
        onChoice(tolerance, this::enterTolerance);
        coherence.addActionListener(event -> enterCoherence());
        automatic.addActionListener(event -> change(scene ->
                scene.withExposure(automatic.isSelected() ? OptionalDouble.empty() : OptionalDouble.of(lastExposure))));
    }

    private void onChoice(JComboBox<String> box, Consumer<String> chosen) {
        box.addActionListener(event -> {
            if (!updating && box.getSelectedItem() instanceof String text) {
                chosen.accept(text);
            }
        });
    }

    private void enterTolerance(String text) {
        try {
            double value = Double.parseDouble(text.strip());
            if (value >= Tolerances.FINEST && value <= Tolerances.COARSEST) {
                plan(old -> PlanChange.tolerance(old, value));
                return;
            }
        } catch (NumberFormatException notANumber) {
            problem.accept("tolerance '" + text + "' is no number; give 1e-5 to 1");
            follow();
            return;
        }
        problem.accept("tolerance " + text + " is out of range; give 1e-5 to 1");
        follow();
    }

    private void enterCoherence() {
        length(coherence, "coherence length", SHORTEST, LONGEST)
                .ifPresentOrElse(metres -> plan(old -> PlanChange.coherenceLength(old, metres)), this::follow);
    }

    /** The method, and for gem the spacing of its lines. */
    private void enterMethod() {
        MethodChoice choice = (MethodChoice) method.getSelectedItem();
        if (updating || choice == null) {
            return;
        }
        if (choice.hasSpacing()) {
            length(spacing, "spacing of the lines", MethodRequest.SMALLEST_SPACING, MethodRequest.LARGEST_SPACING)
                    .ifPresentOrElse(
                            metres -> change(scene -> weights.follow(scene, choice.apply(scene, metres))),
                            this::follow);
        } else {
            change(scene -> weights.follow(scene, choice.apply(scene, 0)));
        }
    }

    /** What a text field says, in metres; or nothing, and the problem told. */
    private OptionalDouble length(JTextField field, String name, double least, double most) {
        String text = field.getText();
        try {
            double metres = Lengths.parse(text);
            if (metres >= least && metres <= most) {
                return OptionalDouble.of(metres);
            }
            problem.accept("%s %s is out of range; give %s to %s"
                    .formatted(name, text, Lengths.format(least), Lengths.format(most)));
        } catch (LengthFormatException notALength) {
            problem.accept(name + ": " + notALength.getMessage());
        }
        return OptionalDouble.empty();
    }

    private void plan(Function<PlanRequest, PlanRequest> change) {
        change(scene -> scene.withPlan(change.apply(scene.plan())));
    }

    private void blend(Function<Blend, Blend> change) {
        change(scene -> scene.withBlend(change.apply(scene.blend())));
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
        mesh.select(scene.mesh());
        patch.select(scene.patch().patch());
        loadedPatches.put(scene.patch().patch(), scene.patch());
        MethodChoice choice = MethodChoice.of(scene);
        method.setSelectedItem(choice);
        scene.method().spacing().ifPresent(metres -> spacing.setText(Lengths.format(metres)));
        spacing.setVisible(choice.hasSpacing());
        spacingCaption.setVisible(choice.hasSpacing());
        tolerance.setSelectedItem(Decimals.format(scene.plan().tolerance()));
        tolerance.setEnabled(choice.hasTolerance());
        average.setEnabled(choice.hasAverages());
        if (!coherence.isFocusOwner()) {
            coherence.setText(Lengths.format(scene.plan().window().coherenceLength()));
        }
        average.setSelectedItem(
                scene.plan().average().orElse(Average.COHERENT).name().toLowerCase(Locale.ROOT));
        rotation.follow(scene.rotatePatch());
        automatic.setSelected(scene.exposure().isEmpty());
        exposure.setEnabled(scene.exposure().isPresent());
        scene.exposure().ifPresent(factor -> {
            lastExposure = factor;
            exposure.follow(factor);
        });
        diffraction.follow(scene.blend().diffraction());
        texture.follow(scene.blend().texture());
        updating = false;
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
