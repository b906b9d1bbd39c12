package sunbeam.precompute.method;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.StatisticsCache;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.PatchIdentity;

/**
 * A surface and the light that colors it: all that a method is planned for but the directions.
 *
 * @param map heights without missing samples
 * @param levels the same, by distinct height
 * @param identity whose tables are whose
 * @param cie the observer and the illuminant
 * @param kept what is known of the heights from earlier runs
 */
public record Surface(HeightMap map, HeightLevels levels, PatchIdentity identity, CieTable cie, StatisticsCache kept) {
    /** A surface of which nothing is known. */
    public Surface(HeightMap map, HeightLevels levels, PatchIdentity identity, CieTable cie) {
        this(map, levels, identity, cie, StatisticsCache.NONE);
    }

    /** A loaded patch under D65. */
    public static Surface of(Patch patch) {
        return of(patch, patch.digest());
    }

    /** A loaded patch under D65 that is planned for alone: nobody asks whose its tables are, which takes a look at all heights. */
    public static Surface withoutIdentity(Patch patch) {
        return of(patch, "");
    }

    private static Surface of(Patch patch, String digest) {
        HeightMap map = patch.heights();
        PatchIdentity identity =
                new PatchIdentity(patch.name(), map.columns(), map.rows(), map.pitchX(), map.pitchY(), digest);
        return new Surface(map, HeightLevels.of(map), identity, CieTable.load());
    }

    /** The same in other light. */
    public Surface under(CieTable light) {
        return new Surface(map, levels, identity, light, kept);
    }

    /** The same, of which nothing is found anew that is kept. */
    public Surface keeping(StatisticsCache numbers) {
        return new Surface(map, levels, identity, cie, numbers);
    }

    /** @throws SettingException where its light has lines, and does not change as gently as daylight */
    void requireSmoothLight() {
        if (!cie.isSmooth()) {
            throw new SettingException(
                    Methods.METHOD,
                    "is for light as smooth as daylight, and this one (" + cie.description()
                            + ") has lines; take full or table");
        }
    }

    /** Plans Fourier tables of it. */
    public Planner planner() {
        return new Planner(map, levels, cie).keeping(kept);
    }

    /** Which surface and which light, as text: equal texts mean equal tables of equal plans. */
    String key() {
        return identity.digest() + "|" + cie.digest();
    }
}
