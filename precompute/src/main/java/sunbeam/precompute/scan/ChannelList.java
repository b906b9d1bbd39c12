package sunbeam.precompute.scan;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Text;

/** Channels of a file with unique labels; chooses the channel that holds the heights. */
public record ChannelList(List<ScanChannel> channels) {
    private static final int MOST_NAMED = 12;
    // Five times as many as any instrument records at once.
    static final int MOST_CHANNELS = 256;

    // Words in vendors' names, lower-case: of channels without heights, with heights, from position sensors.
    private static final Pattern OTHER = Pattern.compile(
            "amplitude|deflection|error|phase|friction|lateral|adhesion|potential|current|stiffness|modulus|dissipation"
                    + "|deformation|indentation|frequency|drive|mask|\\bvdefl|\\bhdefl|slope|intensity|colou?r"
                    + "|\\bred\\b|\\bgreen\\b|\\bblue\\b|\\balpha\\b");
    private static final Pattern HEIGHT =
            Pattern.compile("height|topo|\\bz\\b|\\bz[- _]?(axis|sensor|scan|piezo|drive)|hoehe|h\u00f6he|hauteur");
    private static final Pattern SENSOR = Pattern.compile("sensor|measured|\\blvdt|closed loop");

    /** Throws ScanException if there are no channels or too many. */
    public ChannelList {
        ScanException.refuseIf(channels.isEmpty(), "holds no channel with samples on a grid; export its heights again");
        requireCount(channels.size());
        channels = List.copyOf(channels);
    }

    static void requireCount(long count) {
        ScanException.refuseIf(
                count > MOST_CHANNELS,
                "claims " + count + " channels; at most " + MOST_CHANNELS
                        + " are read, so export the height channel alone");
    }

    public int count() {
        return channels.size();
    }

    /** Returns up to twelve labels and the number of others, for a message. */
    public String names() {
        String names = labels().stream().limit(MOST_NAMED).collect(Collectors.joining(", "));
        int others = count() - MOST_NAMED;
        return others > 0 ? names + " and " + others + " others" : names;
    }

    /** Finds a channel by its label, name (trace before retrace), number from 1, or label without an image's page number. */
    public Optional<Integer> find(String name) {
        String plain = Text.plain(name);
        List<String> labels = labels();
        return traceFirst(i -> Text.plain(labels.get(i)).equals(plain))
                .or(() -> traceFirst(i -> Text.plain(channels.get(i).name()).equals(plain)))
                .or(() -> traceFirst(i -> Integer.toString(i + 1).equals(plain)))
                .or(() -> traceFirst(i -> Text.plain(labels.get(i)).matches("page \\d+ " + Pattern.quote(plain))));
    }

    private Optional<Integer> traceFirst(IntPredicate which) {
        return IntStream.range(0, count())
                .filter(which)
                .boxed()
                .min(Comparator.comparing(i -> channels.get(i).retrace()));
    }

    public Optional<String> nearest(String name) {
        return Text.nearest(name, labels())
                .or(() -> labels().stream()
                        .filter(label -> !name.isBlank() && Text.plain(label).startsWith(Text.plain(name)))
                        .findFirst());
    }

    /** Returns the index of the heights (length unit first, sensor before voltage, trace before retrace), if any. */
    public Optional<Integer> heights() {
        return possible()
                .boxed()
                .min(Comparator.<Integer, Boolean>comparing(
                                i -> channels.get(i).metersPerUnit().isEmpty())
                        .thenComparing(i -> kind(channels.get(i).name()))
                        .thenComparing(i -> channels.get(i).retrace()));
    }

    public long candidates() {
        return possible().count();
    }

    private IntStream possible() {
        return IntStream.range(0, count())
                .filter(i -> channels.get(i).maybeHeights())
                .filter(i -> count() == 1 || kind(channels.get(i).name()) != Kind.OTHER);
    }

    /** Returns a line for each channel: number, label, samples and unit. */
    public List<String> lines() {
        List<String> labels = labels();
        return IntStream.range(0, count())
                .mapToObj(i ->
                        (i + 1) + " " + labels.get(i) + ": " + channels.get(i).describe())
                .toList();
    }

    enum Kind {
        SENSOR_HEIGHT,
        /** From the piezo voltage or an unnamed source. */
        HEIGHT,
        UNNAMED,
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

    /** Returns unique labels: the name, with " (retrace)" if another channel has it, or with the number. */
    public List<String> labels() {
        String[] labels = new String[channels.size()];
        Set<String> taken = new HashSet<>();
        for (int i = 0; i < labels.length; i++) {
            ScanChannel channel = channels.get(i);
            String name = channel.name().isEmpty() ? "channel " + (i + 1) : channel.name();
            Predicate<ScanChannel> same = other -> other.name().equals(channel.name());
            boolean twin = channel.retrace() && channels.stream().filter(same).count() > 1;
            String label = twin ? name + " (retrace)" : name;
            labels[i] = taken.add(label) ? label : label + " #" + (i + 1);
        }
        return List.of(labels);
    }
}
