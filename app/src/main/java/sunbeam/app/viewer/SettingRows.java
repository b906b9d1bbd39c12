package sunbeam.app.viewer;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.io.File;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import sunbeam.app.viewer.ControlPanel.ControlOrigin;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;

/** Column of controls, one per setting, with caption and tooltip. They report entered values and show the current ones. */
final class SettingRows extends JPanel {
    static final String ENTER = "Enter takes it over.";

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

    /** @param low lowest step of the scale */
    void slider(Setting<Double> setting, Scale scale, int low, int high) {
        ValueSlider slider = new ValueSlider(setting, scale, low, high);
        row(setting, slider, "Double click resets it.");
        followers.add(choices -> slider.follow(choices.get(setting)));
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

    /** Combo box of built-in names and files. Files are shown by their last path element; the box keeps its width. */
    static final class NameBox extends JComboBox<String> {
        /** @param names built-in names; file names are cut to about the width of the longest of these */
        NameBox(List<String> names) {
            names.forEach(this::addItem);
            names.stream()
                    .reduce((one, other) -> one.length() < other.length() ? other : one)
                    .ifPresent(this::setPrototypeDisplayValue);
            setRenderer(new LastPart());
        }

        void select(String name) {
            if (name.equals(getSelectedItem())) {
                return;
            }
            if (((DefaultComboBoxModel<String>) getModel()).getIndexOf(name) < 0) {
                addItem(name);
            }
            setSelectedItem(name);
        }

        private static final class LastPart extends DefaultListCellRenderer {
            @Override
            public Component getListCellRendererComponent(
                    JList<?> list, Object name, int index, boolean selected, boolean focused) {
                String path = name == null ? "" : name.toString();
                setToolTipText(path);
                return super.getListCellRendererComponent(list, new File(path).getName(), index, selected, focused);
            }
        }
    }

    /** @param text formats a quantity as a value field shows and accepts it */
    record Scale(DoubleUnaryOperator fromSteps, DoubleUnaryOperator toSteps, DoubleFunction<String> text) {
        static final Scale HUNDREDTHS =
                new Scale(step -> step / 100, weight -> weight * 100, weight -> Text.format("%.2f", weight));
        static final Scale DEGREES = angles(1);
        static final Scale TENTHS_OF_DEGREES = angles(10);
        /** Thirds of a stop: three double the factor. */
        static final Scale STOPS = new Scale(
                step -> Math.pow(2, step / 3),
                factor -> 3 * Math.log(Math.max(1e-9, factor)) / Math.log(2),
                factor -> new BigDecimal(factor)
                        .round(new MathContext(3))
                        .stripTrailingZeros()
                        .toPlainString());

        private static Scale angles(int stepsPerDegree) {
            return new Scale(
                    step -> Math.toRadians(step / stepsPerDegree),
                    angle -> stepsPerDegree * Math.toDegrees(angle),
                    angle -> Text.format("%.1f", Math.toDegrees(angle)));
        }
    }

    /** Slider with an editable value field. Both report changes as text; a double click resets. */
    final class ValueSlider extends JPanel {
        private final JSlider slider;
        private final JTextField value = new JTextField(5);
        private final transient Scale scale;
        private boolean updating;

        ValueSlider(Setting<?> setting, Scale scale, int low, int high) {
            super(new BorderLayout(6, 0));
            this.scale = scale;
            slider = new JSlider(low, high);
            slider.setName(setting.key());
            slider.setPreferredSize(new Dimension(110, slider.getPreferredSize().height));
            add(slider);
            add(value, BorderLayout.EAST);
            slider.addChangeListener(event -> {
                if (!updating) {
                    entered.accept(setting, scale.text.apply(scale.fromSteps.applyAsDouble(slider.getValue())));
                }
            });
            value.addActionListener(event -> entered.accept(setting, value.getText()));
            slider.addMouseListener(new MouseAdapter() {
                @Override
                public void mouseReleased(MouseEvent event) {
                    if (event.getClickCount() == 2) {
                        entered.accept(setting, setting.writtenStandard().orElseThrow());
                    }
                }
            });
        }

        void follow(double quantity) {
            updating = true;
            slider.setValue((int) Math.round(scale.toSteps.applyAsDouble(quantity)));
            SettingRows.show(value, scale.text.apply(quantity));
            updating = false;
        }

        @Override
        public void setToolTipText(String tip) {
            super.setToolTipText(tip);
            slider.setToolTipText(tip);
            value.setToolTipText(tip);
        }
    }
}
