package sunbeam.app.gpu;

import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.plan.Average;

/** Names and values that the shaders are compiled with, whatever the method. */
final class MethodDefines {
    private MethodDefines() {}

    /** A new map with the method and the average chosen. */
    static Map<String, String> of(String method, Average average) {
        Map<String, String> defines = new TreeMap<>();
        defines.put("METHOD_FULL_BINS", "0");
        defines.put("METHOD_FULL_ORDERS", "1");
        defines.put("METHOD_FULL_GRID", "2");
        defines.put("METHOD_NMM", "3");
        defines.put("METHOD_NMM_THESIS", "4");
        defines.put("METHOD_PQ", "5");
        defines.put("METHOD_GEM", "6");
        defines.put("METHOD_FULL_RAYS", "7");
        defines.put("METHOD", method);
        defines.put("AVERAGE_COHERENT", "0");
        defines.put("AVERAGE_ENSEMBLE", "1");
        defines.put("AVERAGE", average == Average.COHERENT ? "AVERAGE_COHERENT" : "AVERAGE_ENSEMBLE");
        defines.put("EXPANSION_TAYLOR", "0");
        defines.put("EXPANSION_SAMPLED", "1");
        defines.put("EXPANSION", "EXPANSION_SAMPLED");
        defines.put("TERMS", "1");
        return defines;
    }
}
