package nephele.engine.model.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;

/** Reads Wavefront OBJ: points, texture coordinates, normals, faces and smoothing groups; materials are ignored. */
final class ObjFile {
    private static final Set<String> WITHOUT_EFFECT = Set.of(
            "o",
            "g",
            "p",
            "l",
            "usemtl",
            "mtllib",
            "usemap",
            "maplib",
            "lod",
            "bevel",
            "c_interp",
            "d_interp",
            "shadow_obj",
            "trace_obj");

    /** Maximum number of corner tests of all polygons together, about half a second. */
    private static final long MOST_TESTS = 50_000_000;

    private final ModelText text;
    private final FloatList places = new FloatList();
    private final FloatList textures = new FloatList();
    private final FloatList normals = new FloatList();
    private final ObjMeshBuilder corners = new ObjMeshBuilder(places, textures, normals);

    /** The number of the smoothing group; 0 is one group for all faces, below 0 each face is its own group. */
    private int smoothingGroup;

    private int faces;
    private long tests;

    ObjFile(String file, byte[] bytes) {
        this.text = new ModelText(file, bytes, "");
    }

    Mesh read() {
        while (text.hasNext()) {
            List<String> words = logicalLine();
            if (!words.isEmpty()) {
                statement(words.get(0), words.subList(1, words.size()));
            }
        }
        if (corners.triangles() == 0) {
            throw text.error("holds no face with an area", "export the mesh with its faces");
        }
        return corners.mesh();
    }

    /** Reads a line and joins it to the next while it ends in a backslash; at the end of the file nothing is joined. */
    private List<String> logicalLine() {
        List<String> words = text.nextLine();
        while (!words.isEmpty() && words.get(words.size() - 1).endsWith("\\")) {
            List<String> joined = new ArrayList<>(words);
            String last = joined.remove(joined.size() - 1);
            if (last.length() > 1) {
                joined.add(last.substring(0, last.length() - 1));
            }
            joined.addAll(text.nextLine());
            words = text.atMost(joined);
        }
        return words;
    }

    private void statement(String word, List<String> values) {
        switch (word) {
            case "v" -> add(places, values, 3, 7);
            case "vt" -> addTexture(values);
            case "vn" -> add(normals, values, 3, 3);
            case "f" -> face(values);
            case "s" -> smoothing(values);
            default -> {
                if (!WITHOUT_EFFECT.contains(word)) {
                    throw text.error(
                            ModelText.quoted(word) + " is no statement that can be read",
                            "export polygons only: v, vt, vn and f");
                }
            }
        }
    }

    /** Adds the first {@code width} values; further ones, such as a colour, are ignored. */
    private void add(FloatList list, List<String> values, int width, int most) {
        if (values.size() < width || values.size() > most) {
            throw text.error("has " + values.size() + " numbers", "write " + width + " numbers");
        }
        if (list.size() / width >= MeshLimits.MAX_VERTICES) {
            throw text.error("there are more than " + MeshLimits.MAX_VERTICES + " of these", "make the mesh coarser");
        }
        for (int i = 0; i < width; i++) {
            list.add(text.coordinate(values.get(i)));
        }
    }

    private void addTexture(List<String> values) {
        if (values.size() == 1) {
            add(textures, List.of(values.get(0), "0"), 2, 3);
        } else {
            add(textures, values, 2, 3);
        }
    }

    private void smoothing(List<String> values) {
        if (values.size() != 1) {
            throw text.error("has " + values.size() + " smoothing groups", "write one number, or off");
        }
        boolean off = values.get(0).equals("off") || values.get(0).equals("0");
        int group = off ? -1 : text.whole(values.get(0));
        if (!off && group < 1) {
            throw text.error(group + " is no smoothing group", "write a number from 1, or off");
        }
        smoothingGroup = group;
    }

    private void face(List<String> words) {
        if (words.size() < 3) {
            throw text.error("a face has " + words.size() + " corners", "write at least three");
        }
        if (words.size() > MeshLimits.MAX_CORNERS) {
            throw text.error(
                    "a face has " + words.size() + " corners, of " + MeshLimits.MAX_CORNERS + " that one may have",
                    "cut the polygon into smaller ones");
        }
        int group = smoothingGroup < 0 ? -1 - faces : smoothingGroup;
        faces++;
        int[][] polygon = new int[words.size()][];
        for (int i = 0; i < polygon.length; i++) {
            polygon[i] = corner(words.get(i), group);
        }
        ItemList triangles = new ItemList();
        tests += PolygonTriangles.cut(places, polygon, MOST_TESTS - tests, triangles);
        for (int i = 0; i < triangles.size(); i += 3) {
            corners.addTriangle(
                    polygon[triangles.get(i)], polygon[triangles.get(i + 1)], polygon[triangles.get(i + 2)]);
        }
        if (tests > MOST_TESTS) {
            throw text.error("the polygons up to here are too jagged", "export triangles");
        }
        if (corners.triangles() > MeshLimits.MAX_TRIANGLES) {
            throw text.error("has more than " + MeshLimits.MAX_TRIANGLES + " triangles", "make the mesh coarser");
        }
    }

    /** Parses a corner: {@code v}, {@code v/vt}, {@code v//vn} or {@code v/vt/vn}. */
    private int[] corner(String word, int group) {
        String[] parts = word.split("/", -1);
        if (parts.length > 3) {
            throw text.error(ModelText.quoted(word) + " is no corner", "write v, v/vt, v//vn or v/vt/vn");
        }
        int place = index(parts[0], places.size() / 3, "point");
        boolean textured = parts.length > 1 && !parts[1].isEmpty();
        int texture = textured ? index(parts[1], textures.size() / 2, "texture coordinates") : ObjMeshBuilder.NONE;
        int normal = parts.length == 3
                ? index(parts[2], normals.size() / 3, "normal")
                : corners.computedNormal(place, group);
        return new int[] {place, texture, normal};
    }

    /** Parses an index from 1, or from -1 backwards, and returns it from 0. */
    private int index(String word, int count, String what) {
        int index = text.whole(word);
        int place = index < 0 ? count + index : index - 1;
        if (place < 0 || place >= count) {
            String advice = count == 0
                    ? "there is none yet: write its line first"
                    : "use 1 to " + count + ", or -1 for the last one";
            throw text.error(index + " names no " + what + " before it", advice);
        }
        return place;
    }
}
