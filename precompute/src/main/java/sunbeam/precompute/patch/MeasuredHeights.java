package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.COLUMNS;
import static sunbeam.precompute.patch.PatchSettings.DECIMAL_MARK;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT_UNIT;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
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
import sunbeam.precompute.scan.UnknownMark;
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
            ScanFormat reader = ScanFormat.find(bytes, choices.find(DECIMAL_MARK))
                    .orElseThrow(() -> new ScanException(
                            "is neither an image nor a scan in a format that Sunbeam knows; if another program, such as"
                                    + " Gwyddion, opens it, export it there as .gwy, .gsf or text"));
            return of(file, reader, reader.open(bytes), choices);
        } catch (UnknownMark ambiguous) {
            throw new SettingException(
                    DECIMAL_MARK,
                    "is missing: " + file + " " + ambiguous.getMessage() + ", or give ",
                    DECIMAL_MARK,
                    " point if commas separate numbers");
        } catch (ScanException unusable) {
            throw new InputException(file + " " + unusable.getMessage(), unusable);
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    private static MeasuredHeights of(Path file, ScanFormat reader, ChannelList channels, Choices choices)
            throws IOException {
        Optional<Integer> only = choices.has(HEIGHT_UNIT) && channels.count() == 1 ? Optional.of(0) : Optional.empty();
        int index = choices.find(CHANNEL)
                .map(wanted -> chosen(file, channels, wanted, choices.has(HEIGHT_UNIT)))
                .or(channels::heights)
                .or(() -> only)
                .orElseThrow(() -> noHeights(file, channels));
        ScanChannel channel = inColumns(file, channels.channels().get(index), reader.isPicture(), choices);
        List<String> notes = new ArrayList<>();
        HeightMap map = scaled(file, channel, choices, notes);
        String label = channels.labels().get(index);
        String which = channels.count() == 1 && channel.name().isEmpty() ? "" : ", channel " + label;
        String source = file.getFileName() + " (" + reader.name() + which + "), " + map.describe();
        boolean several = !choices.has(CHANNEL) && channels.candidates() > 1;
        if (several) {
            notes.add("heights from channel " + label + "; the file has " + channels.names());
        }
        if (!channel.note().isEmpty()) {
            notes.add(channel.note());
        }
        if (channel.name().equals(ScanChannel.PROFILE)) {
            notes.add("a profile of " + map.columns() + " heights: the surface is taken as constant along y");
        }
        return new MeasuredHeights(map, source, channels.lines(), notes);
    }

    private static int chosen(Path file, ChannelList channels, String wanted, boolean hasUnit) {
        String nearest = channels.nearest(wanted)
                .map(name -> " (did you mean " + Text.quoted(name) + "?)")
                .orElse("");
        int index = channels.find(wanted)
                .orElseThrow(() -> new SettingException(
                        CHANNEL, "is no channel of " + file + ", which has " + channels.names() + nearest));
        ScanChannel channel = channels.channels().get(index);
        if (!channel.maybeHeights() && !hasUnit) {
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

    /** Scales by the file's values, which choices complete, or overrule with a note. */
    private static HeightMap scaled(Path file, ScanChannel channel, Choices choices, List<String> notes)
            throws IOException {
        Extent stated = channel.extent();
        boolean fromFullScale = channel.unit().equals(ScanChannel.FULL_SCALE);
        requireOne(choices, fromFullScale);
        Optional<Double> width = preferred(WIDTH, stated.width(), choices, notes);
        Optional<Double> metersPerUnit = metersPerUnit(file, channel, choices, notes);
        if (width.isEmpty() || metersPerUnit.isEmpty()) {
            throw missing(file, width.isEmpty(), metersPerUnit.isEmpty(), fromFullScale);
        }
        // A chosen width keeps the shape of the pixels.
        double stretch = width.get() / stated.width().orElse(width.get());
        Optional<Double> height = preferred(HEIGHT, stated.height().map(side -> side * stretch), choices, notes);
        double pitchX = width.get() / channel.columns();
        double pitchY = height.map(side -> side / channel.rows()).orElse(pitchX * stated.aspect());
        Plausibility.requireSides(width.get(), pitchY * channel.rows(), file, !choices.has(WIDTH));
        double[] heights = channel.samples().scale(metersPerUnit.get(), 0).read();
        HeightMap map = new HeightMap(channel.columns(), channel.rows(), pitchX, pitchY, heights);
        Setting<?> from = choices.has(HEIGHT_UNIT) ? HEIGHT_UNIT : MAX_HEIGHT;
        Plausibility.requireRelief(map, Optional.<Setting<?>>of(from).filter(choices::has), file);
        return map;
    }

    /** Returns the choice, else what the file states. */
    private static Optional<Double> preferred(
            Setting<Double> setting, Optional<Double> stated, Choices choices, List<String> notes) {
        Optional<Double> chosen = choices.find(setting);
        if (chosen.isEmpty() || stated.isEmpty()) {
            return chosen.or(() -> stated);
        }
        if (Math.abs(chosen.get() - stated.get()) <= SAME * stated.get()) {
            return stated;
        }
        notes.add("the " + setting.words(" ") + " is " + Lengths.format(chosen.get())
                + " as chosen, though the file says " + Lengths.format(stated.get()));
        return chosen;
    }

    private static Optional<Double> metersPerUnit(Path file, ScanChannel channel, Choices choices, List<String> notes) {
        Optional<Double> stated = channel.metersPerUnit();
        Optional<Double> chosen = choices.find(HEIGHT_UNIT).flatMap(Extent::metersPer);
        if (choices.has(MAX_HEIGHT)) {
            if (Double.isNaN(channel.span())) {
                throw new SettingException(
                        MAX_HEIGHT,
                        "is for an image's full scale, but " + file + " has heights in " + channel.unit()
                                + "; leave it out, or overrule the unit with ",
                        HEIGHT_UNIT);
            }
            chosen = choices.find(MAX_HEIGHT).map(height -> height / channel.span());
        }
        boolean states = !channel.unit().isEmpty() && !channel.unit().equals(ScanChannel.FULL_SCALE);
        if (states && chosen.isPresent() && !chosen.equals(stated)) {
            notes.add("the heights are scaled as chosen, though the file says that they are in " + channel.unit());
        }
        return chosen.or(() -> stated);
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
