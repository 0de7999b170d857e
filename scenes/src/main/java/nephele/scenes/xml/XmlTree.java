package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Builds a tree from tags. A tag that cannot be in its place closes the elements left open before it, except groups;
 * unknown or misplaced tags are removed, and their content stays.
 */
final class XmlTree {
    private static final int MOST_TAKEN_OUT = 1000;

    private final XmlTags tags;
    private final SceneWarnings warnings;
    private final List<XmlElement> open = new ArrayList<>();
    private final Set<String> takenOut = new HashSet<>();
    private Vocabulary vocabulary;
    private int groups;

    private XmlTree(XmlTags tags, SceneWarnings warnings) {
        this.tags = tags;
        this.warnings = warnings;
    }

    static XmlElement read(String text, SceneWarnings warnings) {
        XmlTags tags = new XmlTags(text, warnings);
        return new XmlTree(tags, warnings).tree();
    }

    static Dialect dialect(XmlElement root) {
        return root.is("world") ? Dialect.WORLD : Dialect.SCENE;
    }

    private XmlElement tree() {
        XmlTag first = tags.next();
        if (first == null) {
            throw warnings.error(1, "there is no tag in it", "begin with <scene> or <world>");
        }
        vocabulary = Vocabulary.of(first.name().equalsIgnoreCase("world") ? Dialect.WORLD : Dialect.SCENE);
        Vocabulary.Word word = vocabulary.word(first.name());
        boolean root = word != null && word.isFrame() && !word.name().equals("group");
        if (!root || first.kind() == XmlTag.Kind.CLOSE) {
            throw warnings.error(
                    first.line(),
                    "it begins with " + SceneWarnings.quoted(first.name()) + ", which is no scene",
                    "begin with <scene> or <world>");
        }
        XmlElement tree = element(word, first);
        if (first.kind() == XmlTag.Kind.OPEN) {
            open.add(tree);
            readContent();
        }
        return tree;
    }

    private void readContent() {
        while (!open.isEmpty()) {
            XmlTag tag = tags.next();
            if (tag == null) {
                closeFrom(0, null);
                return;
            }
            if (tag.kind() == XmlTag.Kind.CLOSE) {
                close(tag);
            } else {
                place(tag);
            }
        }
        XmlTag beyond = tags.next();
        if (beyond != null) {
            warnings.warn(beyond.line(), "the scene has ended: nothing is read from here on");
        }
    }

    private void close(XmlTag tag) {
        int at = open.size() - 1;
        boolean frame = tag.name().equalsIgnoreCase("group");
        while (at > 0
                && !open.get(at).name().equalsIgnoreCase(tag.name())
                && !(open.get(at).word().isFrame())) {
            at--;
        }
        if (!frame && open.get(0).name().equalsIgnoreCase(tag.name())) {
            at = 0;
        }
        if (open.get(at).name().equalsIgnoreCase(tag.name())) {
            closeFrom(at + 1, tag);
            remove(at);
        } else if (!takenOut.contains(key(tag))) {
            warnings.warn(tag.line(), () -> "</" + tag.name() + "> closes nothing: skipped");
        }
    }

    /** @param before {@code null} for the end of the file */
    private void closeFrom(int first, XmlTag before) {
        for (int i = open.size() - 1; i >= first; i--) {
            XmlElement left = open.get(i);
            warnings.warn(
                    left.line(),
                    () -> "<" + left.name() + "> is not closed: it ends before "
                            + (before == null ? "the file's end" : described(before)));
            remove(i);
        }
    }

    private static String described(XmlTag tag) {
        return (tag.kind() == XmlTag.Kind.CLOSE ? "</" : "<") + tag.name() + "> in line " + tag.line();
    }

    private void remove(int at) {
        groups -= open.get(at).is("group") ? 1 : 0;
        open.remove(at);
    }

    private void place(XmlTag tag) {
        Vocabulary.Word word = vocabulary.word(tag.name());
        if (word == null) {
            takeOut(tag);
            warnings.warn(
                    tag.line(),
                    () -> "<" + tag.name() + "> is unknown: skipped"
                            + Vocabulary.suggestion(tag.name(), vocabulary.names()));
            return;
        }
        int parent = open.size() - 1;
        while (!open.get(parent).word().children().contains(word.name())) {
            if (open.get(parent).word().isFrame()) {
                takeOut(tag);
                String around = open.get(open.size() - 1).name();
                warnings.warn(tag.line(), () -> "<" + word.name() + "> does not belong in <" + around + ">: skipped");
                return;
            }
            parent--;
        }
        closeFrom(parent + 1, tag);
        XmlElement element = element(word, tag);
        open.get(parent).add(element);
        if (tag.kind() == XmlTag.Kind.OPEN) {
            open.add(element);
            groups += element.is("group") ? 1 : 0;
        }
        if (groups > XmlSceneFile.MOST_NESTED_GROUPS) {
            String most = String.valueOf(XmlSceneFile.MOST_NESTED_GROUPS);
            throw warnings.error(tag.line(), "groups are nested deeper than " + most, "close some");
        }
    }

    private XmlElement element(Vocabulary.Word word, XmlTag tag) {
        for (XmlAttribute attribute : tag.attributes()) {
            if (!word.attributes().contains(attribute.name())) {
                warnings.warn(
                        attribute.line(),
                        () -> "'" + attribute.name() + "' is unknown in <" + word.name() + ">: skipped"
                                + Vocabulary.suggestion(attribute.name(), word.attributes()));
            }
        }
        return new XmlElement(word, tag);
    }

    /** Marks the element as closed, so that its end tag gives no warning. */
    private void takeOut(XmlTag tag) {
        if (takenOut.size() < MOST_TAKEN_OUT) {
            takenOut.add(key(tag));
        }
    }

    private static String key(XmlTag tag) {
        return tag.name().toLowerCase(Locale.ROOT);
    }
}
