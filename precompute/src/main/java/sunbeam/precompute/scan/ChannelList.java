package sunbeam.precompute.scan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Similar;

/** The channels of a file, under labels that tell them apart, and which of them holds the heights. */
public final class ChannelList {
    /** Labels that a message bears. */
    private static final int MOST_NAMED = 12;

    private final List<ScanChannel> channels;
    private final List<String> labels;

    /** @throws ScanException when there is none, or there are too many */
    public ChannelList(List<ScanChannel> channels) {
        if (channels.isEmpty()) {
            throw new ScanException("holds no channel with samples on a grid; export its heights again");
        }
        ScanLimits.requireChannels(channels.size());
        this.channels = List.copyOf(channels);
        this.labels = ChannelNames.labels(channels);
    }

    public List<ScanChannel> channels() {
        return channels;
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
     * The channel that a user asks for: by its label, its name (trace before retrace), or its number from 1.
     *
     * @return its index; nothing when there is none
     */
    public Optional<Integer> find(String wanted) {
        String plain = plain(wanted);
        Optional<Integer> labelled =
                all().filter(i -> plain(labels.get(i)).equals(plain)).boxed().findFirst();
        Optional<Integer> named = all().filter(
                        i -> plain(channels.get(i).name()).equals(plain))
                .boxed()
                .min(Comparator.comparing(i -> channels.get(i).retrace()));
        return labelled.or(() -> named).or(() -> numbered(plain));
    }

    /** The channel that a user may have meant who asked for one that there is not: its label, or nothing. */
    public Optional<String> nearest(String wanted) {
        return Similar.nearest(wanted, labels)
                .or(() -> labels.stream()
                        .filter(name -> !wanted.isBlank() && plain(name).startsWith(plain(wanted)))
                        .findFirst());
    }

    private Optional<Integer> numbered(String text) {
        return all().filter(i -> Integer.toString(i + 1).equals(text)).boxed().findFirst();
    }

    /**
     * The channel that holds the heights: sensor before voltage, then trace before retrace, then the file's first.
     *
     * @return its index; nothing when no channel can hold heights, or only such whose name says that they are none
     */
    public Optional<Integer> heights() {
        return possible()
                .boxed()
                .min(Comparator.<Integer, Boolean>comparing(
                                i -> channels.get(i).unit().isEmpty())
                        .thenComparing(this::kind)
                        .thenComparing(i -> channels.get(i).retrace()));
    }

    /** How many channels may hold heights, by their units and names. */
    public long candidates() {
        return possible().count();
    }

    private IntStream possible() {
        return all().filter(i -> channels.get(i).maybeHeights())
                .filter(i -> count() == 1 || kind(i) != ChannelNames.Kind.OTHER);
    }

    private ChannelNames.Kind kind(int index) {
        return ChannelNames.kind(channels.get(index).name());
    }

    /** For each channel a line: number, label, samples, unit. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < count(); i++) {
            ScanChannel channel = channels.get(i);
            String unit = channel.unit().isEmpty() ? "no unit" : "in " + channel.unit();
            lines.add(String.format(
                    Locale.ROOT,
                    "%d %s: %d x %d samples, %s",
                    i + 1,
                    labels.get(i),
                    channel.columns(),
                    channel.rows(),
                    unit));
        }
        return lines;
    }

    private IntStream all() {
        return IntStream.range(0, channels.size());
    }

    private static String plain(String name) {
        return name.strip().toLowerCase(Locale.ROOT);
    }
}
