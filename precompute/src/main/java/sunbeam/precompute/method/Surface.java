package sunbeam.precompute.method;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.setting.SettingException;

/** Surface and light for which methods are planned: heights without missing samples, and a name for messages. */
public record Surface(HeightMap map, String name, CieTable cie, Roughness.Cache statistics) {
    public Surface(HeightMap map, String name, CieTable cie) {
        this(map, name, cie, Roughness.Cache.NONE);
    }

    public static Surface of(Patch patch) {
        return new Surface(patch.heights(), patch.name(), CieTable.load());
    }

    public Surface withLight(CieTable light) {
        return new Surface(map, name, light, statistics);
    }

    public Surface withStatistics(Roughness.Cache newStatistics) {
        return new Surface(map, name, cie, newStatistics);
    }

    void requireSmoothLight() {
        if (!cie.isSmooth()) {
            throw new SettingException(
                    Methods.METHOD,
                    "is for light as smooth as daylight, and this one (" + cie.description()
                            + ") has lines or narrow peaks; take full or table");
        }
    }

    public Planner planner() {
        return new Planner(map, cie, statistics);
    }

    /** Returns the SHA-256 of grid and heights in hexadecimal, for cache keys; plans alone do without it. */
    public String digest() {
        return map.digest();
    }

    String key() {
        return digest() + "|" + cie.digest();
    }
}
