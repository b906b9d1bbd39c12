package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.COLUMNS;

import java.nio.file.Path;
import java.util.Optional;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Quoted;

/**
 * The channel of a file that the heights are taken from.
 *
 * @param label what a user calls it
 * @param channel its samples in rows
 */
record ChosenChannel(String label, ScanChannel channel) {
    /** @throws SettingException when a choice does not suit the file, or something must be chosen */
    static ChosenChannel of(Path file, ChannelList channels, boolean picture, Choices choices) {
        int index = choices.find(CHANNEL)
                .map(wanted -> wanted(file, channels, wanted))
                .or(channels::heights)
                .orElseThrow(() -> new SettingException(
                        CHANNEL,
                        "is missing: none of the channels of " + file + " is known to hold heights; choose one of "
                                + channels.names() + " (no channel of a picture in false colors is one)"));
        ScanChannel channel = channels.channels().get(index);
        if (picture && choices.has(COLUMNS)) {
            throw new SettingException(
                    COLUMNS, "is for numbers without rows, but " + file + " is an image; leave it out");
        }
        return new ChosenChannel(channels.label(index), picture ? channel : inColumns(file, channel, choices));
    }

    private static int wanted(Path file, ChannelList channels, String wanted) {
        int index = channels.find(wanted)
                .orElseThrow(() -> new SettingException(
                        CHANNEL,
                        "is no channel of " + file + ", which has " + channels.names()
                                + channels.nearest(wanted)
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
    private static ScanChannel inColumns(Path file, ScanChannel channel, Choices choices) {
        Optional<Integer> columns = choices.find(COLUMNS);
        boolean inRows = channel.rows() > 1 && channel.columns() > 1;
        long count = channel.samples().count();
        if (columns.isEmpty()) {
            boolean isLine = !inRows && channel.extent().width().isEmpty() && count > 2;
            if (isLine && !choices.has(PatchSettings.HEIGHT)) {
                throw new SettingException(
                        COLUMNS,
                        "is missing: " + file + " has its " + count
                                + " numbers in one row or column; say how many make a row");
            }
            return channel;
        }
        if (inRows && columns.get() != channel.columns()) {
            throw new SettingException(
                    COLUMNS, "contradicts " + file + ", whose rows have " + channel.columns() + "; leave it out");
        }
        if (count % columns.get() != 0) {
            throw new SettingException(COLUMNS, "does not divide the " + count + " numbers of " + file);
        }
        return new ScanChannel(
                channel.name(),
                channel.retrace(),
                channel.samples().inRows(columns.get(), (int) (count / columns.get())),
                channel.extent(),
                channel.unit());
    }
}
