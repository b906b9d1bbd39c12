package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * How cost grows along one axis.
 *
 * @param key part of file names: lower-case letters
 * @param axis what grows, with its unit
 * @param points in the order in which they were measured
 * @param remarks what was not measured, and why
 */
record Growth(String key, String axis, List<Point> points, List<String> remarks) {
    /**
     * A measurement.
     *
     * @param x along the axis
     */
    record Point(double x, Measured measured) {}

    Growth {
        points = List.copyOf(points);
        remarks = List.copyOf(remarks);
    }

    /** All points by name, for programs. */
    List<Map<String, Object>> fields() {
        return points.stream()
                .map(point -> {
                    Map<String, Object> fields = new LinkedHashMap<>(Map.of("varied", axis, "value", point.x()));
                    fields.putAll(point.measured().fields());
                    return fields;
                })
                .toList();
    }

    /** By method, in the order in which they first occur. */
    Map<String, List<Point>> byMethod() {
        Map<String, List<Point>> series = new LinkedHashMap<>();
        points.forEach(point -> series.computeIfAbsent(point.measured().method(), name -> new ArrayList<>())
                .add(point));
        return series;
    }
}
