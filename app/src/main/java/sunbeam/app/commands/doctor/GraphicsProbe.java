package sunbeam.app.commands.doctor;

import java.util.List;

/** Opens graphics as rendering does and tells what it found. */
@FunctionalInterface
public interface GraphicsProbe {
    /**
     * Vendor, renderer, version and the limits that matter, each with its remedy where it is too low.
     *
     * @throws jrtr.GraphicsException when there is no context to be had; its message says why and what to do
     */
    List<Check> examine();
}
