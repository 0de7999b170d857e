package nephele.scenes.xml;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import nephele.engine.math.Vec3;

/**
 * Models, lights and subgroups in one frame.
 *
 * @param line its first line; the first is 1
 * @param steps in document order, the first one outermost
 * @param lights the lights of these models and of all subgroups
 */
public record XmlGroup(
        int line, List<Step> steps, List<XmlLight> lights, List<XmlModel> models, List<XmlGroup> groups) {
    /** A part of a group's transform. */
    public sealed interface Step {
        record Translate(Vec3 by) implements Step {}

        /**
         * Motion along a closed uniform Catmull-Rom curve.
         *
         * @param seconds the period
         * @param align true if the frame's x axis follows the curve
         */
        record Follow(double seconds, List<Vec3> points, boolean align) implements Step {}

        record Rotate(Vec3 axis, double angleDegrees) implements Step {}

        /** @param seconds the period */
        record Spin(Vec3 axis, double seconds) implements Step {}

        record Scale(Vec3 by) implements Step {}
    }

    /** Equal as records are, but without recursion: groups may be ten thousand deep. */
    @Override
    public boolean equals(Object other) {
        if (!(other instanceof XmlGroup group)) {
            return false;
        }
        Deque<XmlGroup> ours = new ArrayDeque<>(List.of(this));
        Deque<XmlGroup> theirs = new ArrayDeque<>(List.of(group));
        while (!ours.isEmpty()) {
            XmlGroup our = ours.pop();
            XmlGroup their = theirs.pop();
            if (our.groups.size() != their.groups.size() || !our.content().equals(their.content())) {
                return false;
            }
            our.groups.forEach(ours::push);
            their.groups.forEach(theirs::push);
        }
        return true;
    }

    @Override
    public int hashCode() {
        return content().hashCode();
    }

    @Override
    public String toString() {
        return "XmlGroup" + content();
    }

    private List<Object> content() {
        return List.of(line, steps, lights, models, groups.size());
    }
}
