package sunbeam.app.gpu;

import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.plan.Average;

/** Names and values that the shaders are compiled with, whatever the method. */
final class MethodDefines {
    private MethodDefines() {}

    /**
     * A new map with the method and the average chosen.
     *
     * @param method name of a file in shaders/method, without its ending
     */
    static Map<String, String> of(String method, Average average) {
        Map<String, String> defines = new TreeMap<>();
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
