package sunbeam.app.viewer.panel;

import java.awt.Component;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;

/** Column of controls, one per setting, with caption and tooltip. They report entered values and show the current ones. */
final class SettingRows extends JPanel {
    static final String ENTER = "Enter takes it over.";
    private static final String RESET = "Double click resets it.";

    private final transient BiConsumer<Setting<?>, String> entered;
    private final transient List<Consumer<Choices>> followers = new ArrayList<>();

    SettingRows(BiConsumer<Setting<?>, String> entered) {
        super(new GridBagLayout());
        this.entered = entered;
        setBorder(BorderFactory.createEmptyBorder(6, 12, 6, 12));
    }

    void follow(Choices choices) {
        followers.forEach(follower -> follower.accept(choices));
    }

    void onFollow(Consumer<Choices> follower) {
        followers.add(follower);
    }

    static NameBox words(Setting<?> setting) {
        return new NameBox(List.of(setting.kind().range().split(", ")));
    }

    void box(Setting<?> setting, NameBox box, boolean isEditable) {
        box.setEditable(isEditable);
        row(setting, box, isEditable ? ENTER : "");
        onChoice(box, text -> entered.accept(setting, text));
        followers.add(choices -> {
            // The control keeps its value if the method does not have the setting.
            if (choices.has(setting)) {
                box.select(choices.written(setting));
            }
        });
    }

    void text(Setting<?> setting) {
        JTextField field = new JTextField(8);
        row(setting, field, ENTER);
        field.addActionListener(event -> entered.accept(setting, field.getText()));
        followers.add(choices -> {
            if (!field.isFocusOwner()) {
                show(field, choices.orStandard(setting).written(setting));
            }
        });
    }

    void flag(Setting<Boolean> setting) {
        JCheckBox box = new JCheckBox();
        row(setting, box, "");
        box.addActionListener(event -> entered.accept(setting, String.valueOf(box.isSelected())));
        followers.add(choices -> box.setSelected(choices.get(setting)));
    }

    void slider(Setting<Double> setting, ValueSlider slider) {
        row(setting, slider, RESET);
        followers.add(choices -> slider.follow(choices.get(setting)));
    }

    ValueSlider slider(
            Setting<?> setting,
            int low,
            int high,
            DoubleUnaryOperator fromSlider,
            DoubleUnaryOperator toSlider,
            DoubleFunction<String> text) {
        return new ValueSlider(
                setting.key(),
                low,
                high,
                fromSlider,
                toSlider,
                text,
                setting.writtenStandard().orElseThrow(),
                typed -> entered.accept(setting, typed));
    }

    ValueSlider hundredths(Setting<?> setting, int high) {
        return slider(
                setting, 0, high, step -> step / 100, weight -> weight * 100, weight -> Text.format("%.2f", weight));
    }

    /** @param low lowest value, in thirds of a stop like {@code high}; three thirds double the factor */
    ValueSlider stops(Setting<?> setting, int low, int high) {
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

    static String degrees(double angle) {
        return Text.format("%.1f", Math.toDegrees(angle));
    }

    JLabel row(Setting<?> setting, JComponent control, String more) {
        control.setName(setting.key());
        return row(ControlOrigin.INSTANCE.name(setting), control, ControlOrigin.INSTANCE.tip(setting, more));
    }

    JLabel row(String caption, JComponent control, String tip) {
        control.setToolTipText(tip);
        JLabel label = new JLabel(caption);
        label.setToolTipText(tip);
        label.setLabelFor(control);
        GridBagConstraints place = new GridBagConstraints();
        place.gridy = getComponentCount() / 2;
        place.insets = new Insets(2, 0, 2, 8);
        place.anchor = GridBagConstraints.LINE_START;
        add(label, place);
        place.gridx = 1;
        place.weightx = 1;
        place.insets = new Insets(2, 0, 2, 0);
        place.fill = GridBagConstraints.HORIZONTAL;
        add(control, place);
        scrollTo(control);
        for (Component part : control.getComponents()) {
            scrollTo(part);
        }
        return label;
    }

    /** Scrolls a component into view when it gets the focus by the Tab key. */
    private static void scrollTo(Component part) {
        part.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                ((JComponent) part.getParent()).scrollRectToVisible(part.getBounds());
            }
        });
    }

    static void onChoice(JComboBox<String> box, Consumer<String> chosen) {
        box.addActionListener(event -> {
            if (box.getSelectedItem() instanceof String text) {
                chosen.accept(text);
            }
        });
    }

    /** Sets a field's text only if it changes: each call of setText costs a layout, and a drag of the light would make 60 a second. */
    static void show(JTextField field, String text) {
        if (!field.getText().equals(text)) {
            field.setText(text);
        }
    }
}
