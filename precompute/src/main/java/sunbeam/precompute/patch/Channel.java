package sunbeam.precompute.patch;

import java.util.Arrays;
import java.util.Locale;
import sunbeam.precompute.setting.SettingException;

/** Which channel of an image holds the heights. */
public enum Channel {
    /** The only channel of a grey image, or the common one of a colour image whose red, green and blue are equal. */
    GREY,
    RED,
    GREEN,
    BLUE,
    ALPHA;

    /**
     * The channel of a name.
     *
     * @throws SettingException about {@link PatchSettings#CHANNEL} when there is none
     */
    static Channel of(String name) {
        return Arrays.stream(values())
                .filter(channel -> channel.label().equals(name.toLowerCase(Locale.ROOT)))
                .findFirst()
                .orElseThrow(() -> new SettingException(
                        PatchSettings.CHANNEL, "is not one of grey, red, green, blue, alpha, which images have"));
    }

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
