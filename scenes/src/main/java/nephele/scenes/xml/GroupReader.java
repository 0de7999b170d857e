package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;

/** Reads groups of any depth, without recursion. */
final class GroupReader {
    private final Dialect dialect;
    private final StepReader steps;
    private final LightReader lights;
    private final ModelReader models;

    GroupReader(Dialect dialect, SceneWarnings warnings) {
        this.dialect = dialect;
        this.steps = new StepReader(dialect, warnings);
        this.lights = new LightReader(warnings);
        this.models = new ModelReader(dialect, warnings);
    }

    /** A group whose children are being read. */
    private static final class Open {
        private final XmlElement element;
        private final List<XmlElement> below;
        private final List<XmlGroup> read = new ArrayList<>(0);

        Open(XmlElement element) {
            this.element = element;
            this.below = element.children("group");
        }

        /** Returns the next subgroup, or {@code null} if all are read. */
        XmlElement next() {
            return read.size() < below.size() ? below.get(read.size()) : null;
        }
    }

    XmlGroup root(XmlElement element) {
        List<Open> open = new ArrayList<>();
        open.add(new Open(element));
        while (true) {
            Open last = open.get(open.size() - 1);
            XmlElement next = last.next();
            if (next != null) {
                open.add(new Open(next));
                continue;
            }
            open.remove(open.size() - 1);
            XmlGroup group = group(last);
            if (open.isEmpty()) {
                return group;
            }
            open.get(open.size() - 1).read.add(group);
        }
    }

    private XmlGroup group(Open open) {
        XmlElement element = open.element;
        return new XmlGroup(
                element.line(),
                steps.of(element),
                dialect == Dialect.SCENE ? lights.ofGroup(element) : List.of(),
                models.of(element),
                List.copyOf(open.read));
    }
}
