package sunbeam.precompute.scan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Similar;

/** The channels of a file, under labels that tell them apart, and which of them holds the heights. */
public record ChannelList(List<ScanChannel> channels, List<String> labels) {
    private static final int MOST_NAMED = 12;

    // Instruments call heights by a few dozen names.
    private static final Pattern OTHER = Pattern.compile(
            "amplitude|deflection|error|phase|friction|lateral|adhesion|potential|current|stiffness|modulus|dissipation"
                    + "|deformation|indentation|frequency|drive|mask|\\bvdefl|\\bhdefl|slope|intensity|colou?r"
                    + "|\\bred\\b|\\bgreen\\b|\\bblue\\b|\\balpha\\b");
    private static final Pattern HEIGHT =
            Pattern.compile("height|topo|\\bz\\b|\\bz[- _]?(axis|sensor|scan|piezo|drive)|hoehe|h\u00f6he|hauteur");
    private static final Pattern SENSOR = Pattern.compile("sensor|measured|\\blvdt|closed loop");

    /** @throws ScanException when there is none, or there are too many */
    public ChannelList(List<ScanChannel> channels) {
        this(checked(channels), labels(channels));
    }

    private static List<ScanChannel> checked(List<ScanChannel> channels) {
        if (channels.isEmpty()) {
            throw new ScanException("holds no channel with samples on a grid; export its heights again");
        }
        ScanLimits.requireChannels(channels.size());
        return List.copyOf(channels);
    }

    public int count() {
        return channels.size();
    }

    /** What a user calls a channel. */
    public String label(int index) {
        return labels.get(index);
    }

    /** The labels, as a message lists them. */
    public String names() {
        String names = String.join(", ", labels.subList(0, Math.min(MOST_NAMED, labels.size())));
        int others = labels.size() - MOST_NAMED;
        return others > 0 ? names + " and " + others + " others" : names;
    }

    /**
     * The channel that a user asks for: by its label, its name (trace before retrace), its number from 1, or
     * without the page of an image.
     *
     * @return its index; nothing when there is none
     */
    public Optional<Integer> find(String wanted) {
        String plain = plain(wanted);
        return traceFirst(i -> plain(labels.get(i)).equals(plain))
                .or(() -> traceFirst(i -> plain(channels.get(i).name()).equals(plain)))
                .or(() -> traceFirst(i -> Integer.toString(i + 1).equals(plain)))
                .or(() -> traceFirst(i -> plain(labels.get(i)).matches("page \\d+ " + Pattern.quote(plain))));
    }

    private Optional<Integer> traceFirst(IntPredicate which) {
        return all().filter(which)
                .boxed()
                .min(Comparator.comparing(i -> channels.get(i).retrace()));
    }

    /** The channel that a user may have meant who asked for one that there is not: its label, or nothing. */
    public Optional<String> nearest(String wanted) {
        return Similar.nearest(wanted, labels)
                .or(() -> labels.stream()
                        .filter(name -> !wanted.isBlank() && plain(name).startsWith(plain(wanted)))
                        .findFirst());
    }

    /**
     * The channel that holds the heights: in meters before without unit, sensor before voltage, then trace before retrace, then the file's first.
     *
     * @return its index; nothing when no channel can hold heights, or only such whose name says that they are none
     */
    public Optional<Integer> heights() {
        return possible()
                .boxed()
                .min(Comparator.<Integer, Boolean>comparing(
                                i -> channels.get(i).metersPerUnit().isEmpty())
                        .thenComparing(this::kind)
                        .thenComparing(i -> channels.get(i).retrace()));
    }

    /** How many channels may hold heights, by their units and names. */
    public long candidates() {
        return possible().count();
    }

    private IntStream possible() {
        return all().filter(i -> channels.get(i).maybeHeights()).filter(i -> count() == 1 || kind(i) != Kind.OTHER);
    }

    private Kind kind(int index) {
        return kind(channels.get(index).name());
    }

    /** For each channel a line: number, label, samples, unit. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < count(); i++) {
            ScanChannel channel = channels.get(i);
            String unit = channel.unit().isEmpty() ? "no unit" : "in " + channel.unit();
            lines.add((i + 1) + " " + labels.get(i) + ": " + channel.columns() + " x " + channel.rows() + " samples, "
                    + unit);
        }
        return lines;
    }

    private IntStream all() {
        return IntStream.range(0, channels.size());
    }

    private static String plain(String name) {
        return name.strip().toLowerCase(Locale.ROOT);
    }

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
            labels[i] = taken.add(label) ? label : label + " #" + (i + 1);
        }
        return List.of(labels);
    }
}
