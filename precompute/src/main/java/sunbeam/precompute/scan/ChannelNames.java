package sunbeam.precompute.scan;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;

/** What a channel's name says about it: instruments call heights by a few dozen names. */
final class ChannelNames {
    private static final Pattern OTHER = Pattern.compile(
            "amplitude|deflection|error|phase|friction|lateral|adhesion|potential|current|stiffness|modulus|dissipation"
                    + "|deformation|indentation|frequency|drive|mask|\\bvdefl|\\bhdefl|slope|intensity|colou?r"
                    + "|\\bred\\b|\\bgreen\\b|\\bblue\\b|\\balpha\\b");
    private static final Pattern HEIGHT =
            Pattern.compile("height|topo|\\bz\\b|\\bz[- _]?(axis|sensor|scan|piezo|drive)|hoehe|h\u00f6he|hauteur");
    private static final Pattern SENSOR = Pattern.compile("sensor|measured|\\blvdt|closed loop");

    private ChannelNames() {}

    /** Order of preference, best first. */
    enum Kind {
        /** Heights as a sensor saw them. */
        SENSOR_HEIGHT,
        /** Heights from the voltage at the piezo, or from an unnamed source. */
        HEIGHT,
        /** A name that says nothing. */
        UNNAMED,
        /** Something that is no height, whatever its unit. */
        OTHER
    }

    static Kind kind(String name) {
        // ZSensor and HeightTrace are two words each.
        String words = name.replaceAll("(?<=[a-z])(?=[A-Z])|(?<=Z)(?=[A-Z][a-z])", " ")
                .replace('_', ' ')
                .toLowerCase(Locale.ROOT);
        if (OTHER.matcher(words).find()) {
            return Kind.OTHER;
        }
        boolean height = HEIGHT.matcher(words).find();
        return height ? (SENSOR.matcher(words).find() ? Kind.SENSOR_HEIGHT : Kind.HEIGHT) : Kind.UNNAMED;
    }

    /**
     * Labels that tell channels apart: the name; " (retrace)" where the same name is there as trace; the number where
     * that does not help.
     */
    static List<String> labels(List<ScanChannel> channels) {
        String[] labels = new String[channels.size()];
        Set<String> taken = new HashSet<>();
        for (int i = 0; i < labels.length; i++) {
            ScanChannel channel = channels.get(i);
            String name = channel.name().isEmpty() ? "channel " + (i + 1) : channel.name();
            boolean twin = channel.retrace()
                    && channels.stream()
                                    .filter(other -> other.name().equals(channel.name()))
                                    .count()
                            > 1;
            String label = twin ? name + " (retrace)" : name;
            labels[i] = taken.add(label) ? label : numbered(label, taken);
        }
        return List.of(labels);
    }

    private static String numbered(String label, Set<String> taken) {
        int number = 2;
        while (!taken.add(label + " #" + number)) {
            number++;
        }
        return label + " #" + number;
    }
}
