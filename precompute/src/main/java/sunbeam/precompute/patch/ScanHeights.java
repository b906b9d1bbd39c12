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
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.Extent;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Lengths;

/** Reads the heights of one scan: its own scale, completed by what was chosen. Neither is ever guessed. */
final class ScanHeights {
    /** What six digits, as many as messages show of a length, leave open. */
    private static final double SAME = 1e-5;

    private final Path file;
    private final String format;
    private final Choices choices;

    /** @param format of the file, for people */
    ScanHeights(Path file, String format, Choices choices) {
        this.file = file;
        this.format = format;
        this.choices = choices;
    }

    MeasuredHeights read(List<ScanChannel> found) throws IOException {
        ChannelList channels = new ChannelList(found);
        int index = choose(channels);
        ScanChannel channel = inColumns(channels.channels().get(index));
        requireNoContradiction(channel);
        requireScale(channel);
        double metresPerUnit = channel.metresPerUnit()
                .or(() -> choices.find(HEIGHT_UNIT).map(HeightUnit::metres))
                .orElseThrow();
        double pitchX = channel.extent().width().or(() -> choices.find(WIDTH)).orElseThrow() / channel.columns();
        double pitchY = channel.extent()
                .height()
                .or(() -> choices.find(HEIGHT))
                .map(height -> height / channel.rows())
                .orElse(pitchX * channel.extent().aspect());
        ReliefCheck.requireSize(pitchX * channel.columns(), pitchY * channel.rows(), WIDTH, file);
        double[] heights = Samples.scaled(channel.samples(), metresPerUnit, 0);
        HeightMap map = HeightMap.owning(channel.columns(), channel.rows(), pitchX, pitchY, heights);
        ReliefCheck.requireOfScan(map, channel.metresPerUnit().isEmpty(), file);
        String label = channels.label(index);
        String which = channels.count() == 1 && channel.name().isEmpty() ? "" : ", channel " + label;
        String source = String.format(Locale.ROOT, "%s (%s%s), %s", file.getFileName(), format, which, map.describe());
        return new MeasuredHeights(map, source, channels.lines(), notes(channels, label), PatchScale.oddities(map));
    }

    private int choose(ChannelList channels) {
        Optional<String> wanted = choices.find(CHANNEL);
        if (wanted.isEmpty()) {
            return channels.heights()
                    .orElseThrow(() -> new SettingException(
                            CHANNEL,
                            "is missing: none of the channels of " + file + " is known to hold heights; choose one of "
                                    + channels.names()));
        }
        int index = channels.find(wanted.get())
                .orElseThrow(() -> new SettingException(
                        CHANNEL,
                        "is no channel of " + file + ", which has " + channels.names()
                                + channels.nearest(wanted.get())
                                        .map(name -> " (did you mean " + Quoted.of(name) + "?)")
                                        .orElse("")));
        ScanChannel channel = channels.channels().get(index);
        if (!channel.maybeHeights()) {
            throw new SettingException(
                    CHANNEL,
                    "holds no heights: " + file + " gives it in " + Quoted.of(channel.unit()) + ", no unit of length");
        }
        return index;
    }

    /** A file that writes all numbers in one row does not say where rows end; only the user can. */
    private ScanChannel inColumns(ScanChannel channel) {
        Optional<Integer> columns = choices.find(COLUMNS);
        boolean inRows = channel.rows() > 1 && channel.columns() > 1;
        if (columns.isEmpty()) {
            boolean line = !inRows && channel.extent().width().isEmpty() && channel.columns() * channel.rows() > 2;
            if (line && !choices.has(HEIGHT)) {
                throw new SettingException(
                        COLUMNS,
                        "is missing: " + file + " has its " + (long) channel.columns() * channel.rows()
                                + " numbers in one row or column; say how many make a row");
            }
            return channel;
        }
        if (inRows && columns.get() != channel.columns()) {
            throw new SettingException(
                    COLUMNS, "contradicts " + file + ", whose rows have " + channel.columns() + "; leave it out");
        }
        long count = (long) channel.columns() * channel.rows();
        if (count % columns.get() != 0) {
            throw new SettingException(COLUMNS, "does not divide the " + count + " numbers of " + file);
        }
        return new ScanChannel(
                channel.name(),
                columns.get(),
                (int) (count / columns.get()),
                channel.extent(),
                channel.unit(),
                channel.source());
    }

    private void requireNoContradiction(ScanChannel channel) {
        Extent extent = channel.extent();
        refuseAnother(WIDTH, extent.width(), "wide");
        refuseAnother(HEIGHT, extent.height(), "high");
        Optional<String> unit = channel.metresPerUnit().map(metres -> "has heights in " + channel.unit());
        boolean agrees = choices.find(HEIGHT_UNIT)
                .map(chosen -> same(chosen.metres(), channel.metresPerUnit().orElse(chosen.metres())))
                .orElse(true);
        refuse(HEIGHT_UNIT, agrees ? Optional.empty() : unit);
        refuse(MAX_HEIGHT, unit);
        if (choices.has(MAX_HEIGHT)) {
            throw new SettingException(
                    MAX_HEIGHT, "is for images; " + file + " is none: give the unit of its numbers with ", HEIGHT_UNIT);
        }
    }

    private void refuseAnother(Setting<Double> setting, Optional<Double> known, String dimension) {
        refuse(
                setting,
                known.filter(length -> !same(choices.find(setting).orElse(length), length))
                        .map(length -> "is " + Lengths.format(length) + " " + dimension + " by its own header"));
    }

    /** As far as people write it. */
    private static boolean same(double said, double known) {
        return Math.abs(said - known) <= SAME * known;
    }

    private void refuse(Setting<?> setting, Optional<String> known) {
        if (choices.has(setting) && known.isPresent()) {
            throw new SettingException(setting, "contradicts " + file + ", which " + known.get() + "; leave it out");
        }
    }

    private void requireScale(ScanChannel channel) {
        boolean width = channel.extent().width().isPresent() || choices.has(WIDTH);
        boolean unit = channel.metresPerUnit().isPresent() || choices.has(HEIGHT_UNIT);
        if (!width && !unit) {
            throw new SettingException(
                    WIDTH,
                    "is missing: " + file + " (" + format
                            + ") says neither how large the scan is nor in which unit its heights are; add for example ",
                    WIDTH,
                    " 20um and ",
                    HEIGHT_UNIT,
                    " nm");
        }
        if (!width) {
            throw new SettingException(
                    WIDTH,
                    "is missing: " + file + " (" + format + ") does not say how large the scan is; add for"
                            + " example ",
                    WIDTH,
                    " 20um");
        }
        if (!unit) {
            throw new SettingException(
                    HEIGHT_UNIT,
                    "is missing: " + file + " (" + format + ") does not say in which unit its heights are;"
                            + " add for example ",
                    HEIGHT_UNIT,
                    " nm");
        }
    }

    private List<String> notes(ChannelList channels, String label) {
        if (channels.count() == 1 || choices.has(CHANNEL)) {
            return List.of();
        }
        return List.of(String.format(Locale.ROOT, "heights from channel %s; the file has %s", label, channels.names()));
    }
}
