package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;

/** Reads and writes the face entries of every kind of solid, by the names of {@link Brush.BrushFace}. */
public final class SolidFaces {
    private SolidFaces() {}

    /** Returns the names of a solid's faces; a plane that bounds nothing is among them. */
    public static List<String> names(Solid solid) {
        List<String> names = new ArrayList<>();
        if (solid instanceof Solid.Planes planes) {
            IntStream.range(0, planes.planes().size()).forEach(i -> names.add(plane(i)));
        } else if (solid instanceof Solid.Prism prism) {
            names.addAll(List.of("+y", "-y"));
            IntStream.range(0, prism.sides()).forEach(i -> names.add("side " + i));
        } else {
            for (BoxFace side : BoxFace.values()) {
                names.add(side.text());
            }
        }
        if (solid instanceof Solid.Wedge wedge) {
            names.remove("+y");
            names.removeIf(
                    name -> name.substring(1).equals(wedge.rising().text().substring(1))
                            && !name.equals(wedge.rising().text()));
            names.add("slope");
        }
        return names;
    }

    /** Returns what a solid says of its faces: no entry for a face of which it says nothing, but for planes. */
    public static Map<String, Solid.Face> authored(Solid solid) {
        if (solid instanceof Solid.Wedge wedge) {
            return wedge.faces();
        } else if (solid instanceof Solid.Prism prism) {
            return prism.faces();
        }
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        if (solid instanceof Solid.Box box) {
            box.faces().forEach((side, face) -> faces.put(side.text(), face));
        } else if (solid instanceof Solid.Planes planes) {
            for (int i = 0; i < planes.planes().size(); i++) {
                Solid.PlaneFace authored = planes.planes().get(i);
                faces.put(plane(i), new Solid.Face(authored.material(), authored.portalable(), authored.texture()));
            }
        }
        return faces;
    }

    /** Returns the place of what is said of a face in its solid's record, such as {@code faces.+y} and {@code planes[3]}. */
    public static String path(Solid solid, String face) {
        return solid instanceof Solid.Planes ? face : "faces." + face;
    }

    /** Returns what a solid says of one face. */
    public static Solid.Face authored(Solid solid, String face) {
        return authored(solid).getOrDefault(face, Solid.Face.INHERITED);
    }

    /**
     * Returns a solid that says something else of one face. A placement that changes nothing is left out.
     *
     * @throws IllegalArgumentException if the solid has no such face
     */
    public static Solid with(Solid solid, String face, Solid.Face authored) {
        if (!names(solid).contains(face)) {
            throw new IllegalArgumentException(solid.id() + " has no face " + face);
        }
        return withKnown(
                solid,
                face,
                TexturePlacement.NONE.equals(authored.texture())
                        ? new Solid.Face(authored.material(), authored.portalable(), null)
                        : authored);
    }

    private static Solid withKnown(Solid solid, String face, Solid.Face authored) {
        if (solid instanceof Solid.Box box) {
            BoxFace side = BoxFace.values()[names(solid).indexOf(face)];
            return box.withFaces(with(box.faces(), side, authored));
        } else if (solid instanceof Solid.Wedge wedge) {
            return wedge.withFaces(with(wedge.faces(), face, authored));
        } else if (solid instanceof Solid.Prism prism) {
            return prism.withFaces(with(prism.faces(), face, authored));
        }
        return with((Solid.Planes) solid, names(solid).indexOf(face), authored);
    }

    private static Solid with(Solid.Planes solid, int index, Solid.Face authored) {
        List<Solid.PlaneFace> planes = new ArrayList<>(solid.planes());
        Solid.PlaneFace plane = planes.get(index);
        planes.set(
                index,
                new Solid.PlaneFace(
                        plane.normal(),
                        plane.distanceMetres(),
                        authored.material(),
                        authored.portalable(),
                        authored.texture()));
        return solid.withPlanes(Collections.unmodifiableList(planes));
    }

    private static <N> Map<N, Solid.Face> with(Map<N, Solid.Face> faces, N name, Solid.Face authored) {
        Map<N, Solid.Face> changed = new TreeMap<>(faces);
        if (authored.equals(Solid.Face.INHERITED)) {
            changed.remove(name);
        } else {
            changed.put(name, authored);
        }
        return changed.isEmpty() ? Map.of() : Collections.unmodifiableMap(changed);
    }

    private static String plane(int index) {
        return "planes[" + index + "]";
    }
}
