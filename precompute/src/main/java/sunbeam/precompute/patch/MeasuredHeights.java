package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.COLUMNS;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT_UNIT;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanFormat;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Heights of a file, in meters with NaN for missing samples, before any preparation. */
record MeasuredHeights(HeightMap map, String source, List<String> channels, List<String> notes) {
    // Relative; users copy lengths of six digits from messages.
    private static final double SAME = 1e-5;

    /**
     * @throws InputException if the file cannot be used
     * @throws SettingException if a choice contradicts the file, is absurd or is missing
     */
    static MeasuredHeights read(Path file, Choices choices) {
        InputException.requireRegular(file);
        try (ScanBytes bytes = ScanBytes.open(file)) {
            ScanException.refuseIf(bytes.size() == 0, "is empty; copy or export it again");
            ScanFormat reader = ScanFormat.find(bytes, choices.find(PatchSettings.DECIMAL_MARK))
                    .orElseThrow(() -> new ScanException(
                            "is neither an image nor a scan in a format that Sunbeam knows; open it with Gwyddion,"
                                    + " which reads 170 others, and export it as .gwy, .gsf or text"));
            return of(file, reader, reader.open(bytes), choices);
        } catch (ScanException unusable) {
            throw new InputException(file + " " + unusable.getMessage(), unusable);
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private static MeasuredHeights of(Path file, ScanFormat reader, ChannelList channels, Choices choices)
            throws IOException {
        int index = choices.find(CHANNEL)
                .map(wanted -> chosen(file, channels, wanted))
                .or(channels::heights)
                .orElseThrow(() -> noHeights(file, channels));
        ScanChannel channel = inColumns(file, channels.channels().get(index), reader.isPicture(), choices);
        HeightMap map = scaled(file, channel, choices);
        String label = channels.labels().get(index);
        String which = channels.count() == 1 && channel.name().isEmpty() ? "" : ", channel " + label;
        String source = file.getFileName() + " (" + reader.name() + which + "), " + map.describe();
        boolean several = !choices.has(CHANNEL) && channels.candidates() > 1;
        List<String> notes =
                several ? List.of("heights from channel " + label + "; the file has " + channels.names()) : List.of();
        return new MeasuredHeights(map, source, channels.lines(), notes);
    }

    private static int chosen(Path file, ChannelList channels, String wanted) {
        String nearest = channels.nearest(wanted)
                .map(name -> " (did you mean " + Text.quoted(name) + "?)")
                .orElse("");
        int index = channels.find(wanted)
                .orElseThrow(() -> new SettingException(
                        CHANNEL, "is no channel of " + file + ", which has " + channels.names() + nearest));
        ScanChannel channel = channels.channels().get(index);
        if (!channel.maybeHeights()) {
            throw new SettingException(
                    CHANNEL,
                    "holds no heights: " + file + " gives it in " + Text.quoted(channel.unit())
                            + ", no unit of length");
        }
        return index;
    }

    private static RuntimeException noHeights(Path file, ChannelList channels) {
        return channels.channels().stream().noneMatch(ScanChannel::maybeHeights)
                ? new InputException(file + " holds no heights: none of its channels has a unit of length ("
                        + String.join("; ", channels.lines().subList(0, Math.min(3, channels.count())))
                        + "); export the height")
                : new SettingException(
                        CHANNEL,
                        "is missing: none of the channels of " + file + " is known to hold heights; choose one of "
                                + channels.names() + " (no channel of a picture in false colors is one)");
    }

    /** Splits a single row or column of numbers. */
    private static ScanChannel inColumns(Path file, ScanChannel channel, boolean picture, Choices choices) {
        Optional<Integer> columns = choices.find(COLUMNS);
        Samples samples = channel.samples();
        boolean inRows = samples.rows() > 1 && samples.columns() > 1;
        if (picture && columns.isPresent()) {
            throw new SettingException(
                    COLUMNS, "is for numbers without rows, but " + file + " is an image; leave it out");
        }
        if (columns.isEmpty()) {
            boolean line = !picture && !inRows && channel.extent().width().isEmpty() && samples.count() > 2;
            if (line && !choices.has(PatchSettings.HEIGHT)) {
                throw new SettingException(
                        COLUMNS,
                        "is missing: " + file + " has its " + samples.count()
                                + " numbers in one row or column; say how many make a row");
            }
            return channel;
        }
        if (inRows && columns.get() != samples.columns()) {
            throw new SettingException(
                    COLUMNS, "contradicts " + file + ", whose rows have " + samples.columns() + "; leave it out");
        }
        if (samples.count() % columns.get() != 0) {
            throw new SettingException(COLUMNS, "does not divide the " + samples.count() + " numbers of " + file);
        }
        return channel.reshape(columns.get(), (int) (samples.count() / columns.get()));
    }

    /** Scales by the file's values, completed by choices, which may repeat but not contradict them. */
    private static HeightMap scaled(Path file, ScanChannel channel, Choices choices) throws IOException {
        Optional<Double> width = agreed(WIDTH, channel.extent().width(), choices.find(WIDTH), file);
        Optional<Double> height = agreed(HEIGHT, channel.extent().height(), choices.find(HEIGHT), file);
        Optional<Double> chosen = choices.find(HEIGHT_UNIT).flatMap(Extent::metersPer);
        Optional<Double> unit = agreed(HEIGHT_UNIT, channel.metersPerUnit(), chosen, file);
        Optional<Double> fullScale = agreed(MAX_HEIGHT, channel.metersPerUnit(), choices.find(MAX_HEIGHT), file);
        boolean fromFullScale = channel.unit().equals(ScanChannel.FULL_SCALE);
        requireOne(choices, fromFullScale);
        Optional<Double> metersPerUnit = unit.or(() -> fullScale);
        if (width.isEmpty() || metersPerUnit.isEmpty()) {
            throw missing(file, width.isEmpty(), metersPerUnit.isEmpty(), fromFullScale);
        }
        double pitchX = width.get() / channel.columns();
        double pitchY = height.map(side -> side / channel.rows())
                .orElse(pitchX * channel.extent().aspect());
        boolean own = channel.extent().width().isPresent();
        Plausibility.requireSides(pitchX * channel.columns(), pitchY * channel.rows(), file, own);
        double[] heights = channel.samples().scale(metersPerUnit.get(), 0).read();
        HeightMap map = new HeightMap(channel.columns(), channel.rows(), pitchX, pitchY, heights);
        Optional<Setting<?>> from = Optional.of(choices.has(HEIGHT_UNIT) ? HEIGHT_UNIT : MAX_HEIGHT);
        Plausibility.requireRelief(
                map, from.filter(scaled -> channel.metersPerUnit().isEmpty()), file);
        return map;
    }

    private static Optional<Double> agreed(
            Setting<?> setting, Optional<Double> known, Optional<Double> chosen, Path file) {
        if (known.isPresent() && chosen.isPresent() && Math.abs(chosen.get() - known.get()) > SAME * known.get()) {
            throw new SettingException(
                    setting,
                    "contradicts " + file + ", which says " + Lengths.format(known.get()) + " itself; leave it out");
        }
        return known.or(() -> chosen);
    }

    private static void requireOne(Choices choices, boolean fromFullScale) {
        if (choices.has(MAX_HEIGHT) && choices.has(HEIGHT_UNIT)) {
            throw new SettingException(HEIGHT_UNIT, "contradicts ", MAX_HEIGHT, "; give one of them");
        }
        if (fromFullScale && choices.has(HEIGHT_UNIT)) {
            throw new SettingException(
                    HEIGHT_UNIT,
                    "is for numbers without unit; of an image's whole numbers give the height of full scale with ",
                    MAX_HEIGHT);
        }
    }

    private static SettingException missing(Path file, boolean width, boolean unit, boolean fromFullScale) {
        Setting<?> ofHeights = fromFullScale ? MAX_HEIGHT : HEIGHT_UNIT;
        String lacks = fromFullScale
                ? " is an image without scale"
                : " does not say "
                        + (width ? "how large the scan is" + (unit ? " nor " : "") : "")
                        + (unit ? "in which unit its heights are" : "");
        String what = "is missing: " + file + lacks + "; add for example ";
        String heights = fromFullScale ? " 375nm, or name a descriptor (.json)" : " nm";
        String sides = fromFullScale ? " 65um" : " 20um";
        if (!width) {
            return new SettingException(ofHeights, what, ofHeights, heights);
        }
        return unit
                ? new SettingException(WIDTH, what, WIDTH, sides + " and ", ofHeights, heights)
                : new SettingException(WIDTH, what, WIDTH, sides);
    }
}
