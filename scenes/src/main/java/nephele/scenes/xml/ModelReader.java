package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlModel.Colours;

/** Reads models: meshes and their appearance. */
final class ModelReader {
    /** The default material of fixed-function OpenGL. */
    private static final Colours SCENE_LOOK = new Colours(grey(0.8), grey(0.2), Vec3.ZERO, Vec3.ZERO, 0);

    private static final Colours WORLD_LOOK = new Colours(grey(200.0 / 255), grey(50.0 / 255), Vec3.ZERO, Vec3.ZERO, 0);
    private static final double MOST_SHININESS = 128;

    private final Dialect dialect;
    private final SceneWarnings warnings;

    ModelReader(Dialect dialect, SceneWarnings warnings) {
        this.dialect = dialect;
        this.warnings = warnings;
    }

    private static Vec3 grey(double value) {
        return new Vec3(value, value, value);
    }

    List<XmlModel> of(XmlElement holder) {
        List<XmlModel> models = new ArrayList<>(1);
        for (XmlElement child : holder.children()) {
            if (child.is("model")) {
                add(child, models);
            } else if (child.is("models")) {
                child.children().forEach(model -> add(model, models));
            }
        }
        return List.copyOf(models);
    }

    private void add(XmlElement element, List<XmlModel> models) {
        ElementValues values = new ElementValues(element, warnings);
        String file = file(values, "file");
        if (file == null) {
            values.warn("it names no file: skipped");
        } else if (dialect == Dialect.SCENE) {
            models.add(new XmlModel(element.line(), file, file(values, "texture"), sceneLook(values)));
        } else {
            models.add(new XmlModel(element.line(), file, worldTexture(element), worldLook(element)));
        }
    }

    /** Returns a file name with separators of any system. @return {@code null} for none */
    private static String file(ElementValues values, String name) {
        String written = values.text(name);
        return written == null ? null : written.replace('\\', '/').replaceFirst("^(\\./)+", "");
    }

    private static Colours sceneLook(ElementValues values) {
        return new Colours(
                colour(values, 1, SCENE_LOOK.diffuse(), "diffR", "diffG", "diffB"),
                colour(values, 1, SCENE_LOOK.ambient(), "ambtR", "ambtG", "ambtB"),
                colour(values, 1, SCENE_LOOK.specular(), "specR", "specG", "specB"),
                colour(values, 1, SCENE_LOOK.emissive(), "emisR", "emisG", "emisB"),
                values.number("shininess", 0, 0, MOST_SHININESS));
    }

    private String worldTexture(XmlElement model) {
        String file = null;
        for (XmlElement texture : model.children("texture")) {
            ElementValues values = new ElementValues(texture, warnings);
            if (file != null) {
                values.warn("a model has one: the first counts");
            } else if (file(values, "file") == null) {
                values.warn("it names no file: skipped");
            } else {
                file = file(values, "file");
            }
        }
        return file;
    }

    private Colours worldLook(XmlElement model) {
        List<XmlElement> terms = model.children("color").stream()
                .flatMap(color -> color.children().stream())
                .toList();
        double shininess = 0;
        Vec3[] colours = {WORLD_LOOK.diffuse(), WORLD_LOOK.ambient(), WORLD_LOOK.specular(), WORLD_LOOK.emissive()};
        for (XmlElement term : terms) {
            ElementValues values = new ElementValues(term, warnings);
            if (term.is("shininess")) {
                shininess = values.number("value", 0, 0, MOST_SHININESS);
            } else {
                int at = List.of("diffuse", "ambient", "specular", "emissive").indexOf(term.name());
                colours[at] = colour(values, 255, colours[at], "R", "G", "B");
            }
        }
        return new Colours(colours[0], colours[1], colours[2], colours[3], shininess);
    }

    /** @param full the number that stands for 1 */
    private static Vec3 colour(ElementValues values, double full, Vec3 absent, String r, String g, String b) {
        if (!values.hasAny(r, g, b)) {
            return absent;
        }
        return new Vec3(
                values.number(r, 0, 0, full) / full,
                values.number(g, 0, 0, full) / full,
                values.number(b, 0, 0, full) / full);
    }
}
