package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.math.Vec3;

/** Reads lights: those of a whole {@code <world>}, or those of one group. */
final class LightReader {
    /** The number of lights of fixed-function OpenGL. */
    private static final int MOST_IN_WORLD = 8;

    private static final double ALL_AROUND_DEGREES = 180;

    private final SceneWarnings warnings;

    LightReader(SceneWarnings warnings) {
        this.warnings = warnings;
    }

    List<XmlLight> ofGroup(XmlElement holder) {
        List<XmlLight> lights = new ArrayList<>(0);
        for (XmlElement child : holder.children()) {
            if (child.is("light")) {
                add(child, lights);
            } else if (child.is("lights")) {
                child.children().forEach(light -> add(light, lights));
            }
        }
        return List.copyOf(lights);
    }

    List<XmlLight> ofWorld(XmlElement world) {
        List<XmlElement> elements = world.children("lights").stream()
                .flatMap(lights -> lights.children().stream())
                .toList();
        List<XmlLight> lights = new ArrayList<>(0);
        elements.stream().limit(MOST_IN_WORLD).forEach(light -> add(light, lights));
        if (elements.size() > MOST_IN_WORLD) {
            warnings.warn(
                    elements.get(MOST_IN_WORLD).line(),
                    "a <world> has " + MOST_IN_WORLD + " lights at most: the others are skipped");
        }
        return List.copyOf(lights);
    }

    private void add(XmlElement element, List<XmlLight> lights) {
        ElementValues values = new ElementValues(element, warnings);
        String type = values.text("type");
        Vec3 position = values.vector("posx", "posy", "posz", 0);
        switch (type == null ? "" : type.toLowerCase(Locale.ROOT)) {
            case "point" -> lights.add(new XmlLight.Point(position));
            case "directional" -> {
                boolean named = values.hasAny("dirx", "diry", "dirz");
                Vec3 towards = named ? values.vector("dirx", "diry", "dirz", 0) : position;
                if (hasLength(towards)) {
                    lights.add(new XmlLight.Directional(towards));
                } else {
                    values.warn("its direction has no length: skipped");
                }
            }
            case "spot", "spotlight" -> lights.add(spot(values, position));
            default ->
                values.warn((type == null ? "it has no type" : "its type " + SceneWarnings.quoted(type) + " is unknown")
                        + ": skipped; write point, directional or spot");
        }
    }

    private static XmlLight spot(ElementValues values, Vec3 position) {
        double cutoff = values.number("cutoff", ALL_AROUND_DEGREES, 0, ALL_AROUND_DEGREES);
        if (cutoff > 90 && cutoff < ALL_AROUND_DEGREES) {
            values.warn("its cutoff is above 90 and not 180: taken as 90");
            cutoff = 90;
        }
        return new XmlLight.Spot(position, spotDirection(values), cutoff, values.number("exponent", 0, 0, 128));
    }

    private static Vec3 spotDirection(ElementValues values) {
        boolean named = values.hasAny("spotdirx", "spotdiry", "spotdirz");
        Vec3 direction =
                named ? values.vector("spotdirx", "spotdiry", "spotdirz", 0) : values.vector("dirx", "diry", "dirz", 0);
        if (hasLength(direction)) {
            return direction;
        }
        if (named || values.hasAny("dirx", "diry", "dirz")) {
            values.warn("its direction has no length: taken as 0 0 -1");
        }
        return new Vec3(0, 0, -1);
    }

    private static boolean hasLength(Vec3 direction) {
        return direction.toVector().lengthSquared() > 0;
    }
}
