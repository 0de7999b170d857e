package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlGroup.Step;

/** Reads the steps of groups. */
final class StepReader {
    private static final int CURVE_POINTS = 4;
    private static final double LEAST_SECONDS = 1e-6;

    private final Dialect dialect;
    private final SceneWarnings warnings;

    StepReader(Dialect dialect, SceneWarnings warnings) {
        this.dialect = dialect;
        this.warnings = warnings;
    }

    List<Step> of(XmlElement group) {
        List<Step> steps = new ArrayList<>(3);
        Set<String> found = new HashSet<>();
        for (XmlElement child : group.children()) {
            if (child.is("transform")) {
                if (!found.add(child.name())) {
                    new ElementValues(child, warnings).warn("a group has one: this one goes on where that ended");
                }
                child.children().forEach(step -> read(step).ifPresent(steps::add));
            } else if (isStep(child)) {
                if (found.add(child.name())) {
                    read(child).ifPresent(steps::add);
                } else {
                    new ElementValues(child, warnings).warn("a group has at most one: the first counts");
                }
            }
        }
        return List.copyOf(steps);
    }

    private boolean isStep(XmlElement element) {
        return dialect == Dialect.SCENE && (element.is("translate") || element.is("rotate") || element.is("scale"));
    }

    private Optional<Step> read(XmlElement element) {
        ElementValues values = new ElementValues(element, warnings);
        return switch (element.name()) {
            case "translate" -> Optional.of(translate(element, values));
            case "rotate" -> rotate(values);
            default -> Optional.of(scale(values));
        };
    }

    private Step translate(XmlElement element, ElementValues values) {
        List<Vec3> points = element.children("point").stream()
                .map(point -> new ElementValues(point, warnings).vector("x", "y", "z", 0))
                .toList();
        double seconds = seconds(values);
        if (points.isEmpty()) {
            if (values.has("time")) {
                values.warn("it has time but no <point>: it stands");
            }
            return new Step.Translate(values.vector("x", "y", "z", 0));
        }
        if (values.hasAny("x", "y", "z")) {
            values.warn("it has points: x, y and z do not count");
        }
        if (seconds == 0) {
            if (!values.has("time")) {
                values.warn("it has points but no time: it stands at the first one");
            }
            return new Step.Translate(points.get(0));
        }
        if (points.size() < CURVE_POINTS) {
            values.warn("a curve has four points or more, this one " + points.size());
        }
        return new Step.Follow(seconds, points, values.flag("align"));
    }

    private Optional<Step> rotate(ElementValues values) {
        boolean named = values.hasAny("axisX", "axisY", "axisZ");
        Vec3 axis = named ? values.vector("axisX", "axisY", "axisZ", 0) : values.vector("x", "y", "z", 0);
        if (axis.toVector().lengthSquared() == 0) {
            values.warn("its axis has no direction: it turns nothing");
            return Optional.empty();
        }
        double seconds = seconds(values);
        if (seconds == 0) {
            if (!values.hasAny("angle", "time")) {
                values.warn("it has neither angle nor time: it turns nothing");
            }
            return Optional.of(new Step.Rotate(axis, values.number("angle", 0)));
        }
        if (values.has("angle")) {
            values.warn("it has time: angle does not count");
        }
        return Optional.of(new Step.Spin(axis, seconds));
    }

    /**
     * Reads a scale; a missing factor is 0, as everywhere, and an unreadable one is 1, since 0 would hide everything.
     */
    private Step scale(ElementValues values) {
        Vec3 by = new Vec3(factor(values, "x"), factor(values, "y"), factor(values, "z"));
        if (by.x() == 0 || by.y() == 0 || by.z() == 0) {
            values.warn("it is flat: " + flatAxes(by) + " is 0 (axes that are left out are)");
        }
        return new Step.Scale(by);
    }

    private static double factor(ElementValues values, String axis) {
        return values.has(axis) ? values.number(axis, 1) : 0;
    }

    private static String flatAxes(Vec3 by) {
        return String.join(
                " and ",
                Stream.of(by.x() == 0 ? "x" : "", by.y() == 0 ? "y" : "", by.z() == 0 ? "z" : "")
                        .filter(axis -> !axis.isEmpty())
                        .toList());
    }

    /** Returns the seconds. @return 0 for none */
    private static double seconds(ElementValues values) {
        double seconds = values.number("time", 0);
        if (Math.abs(seconds) >= LEAST_SECONDS) {
            return seconds;
        }
        if (values.has("time")) {
            values.warn("it has no time to move in: it stands");
        }
        return 0;
    }
}
