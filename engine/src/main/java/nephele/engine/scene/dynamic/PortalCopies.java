package nephele.engine.scene.dynamic;

import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The poses of one dynamic object: its parts, and a copy of them for every portal that a part reaches through. The part
 * in front of a portal is clipped at the portal's plane, its image at the exit's; together they make up the whole part
 * once. One object serves all dynamic objects without growing.
 *
 * <p>A part reaches through a portal if the segment from its anchor, in front of the portal, to its deepest point
 * behind the plane passes through the aperture; the intersection with the plane is inside a body, because a body is
 * convex and its anchor is its centre.
 */
final class PortalCopies {
    /** Portals that face each other would make infinitely many copies; the omitted ones are small parts. */
    static final int MOST_COPIES = 8;

    static final int MOST_PARTS = 24;

    /**
     * The greatest number of clip planes of a part, which is the number of clip distances that the shader provides. A
     * part reaches through no further portal.
     */
    static final int MOST_PLANES = 2;

    /** The least depth behind a portal's plane: a part that only touches it does not reach through. */
    private static final double SLACK_METRES = 1e-6;

    private static final double OFF_METRES = 0.2;

    /**
     * Offsets in a slot: orientation x y z w, centre, anchor, and for each clip plane its normal and the signed
     * distance of the centre.
     */
    private static final int CENTRE = 4;

    private static final int ANCHOR = 7;
    private static final int PLANES = 10;
    private static final int STRIDE = PLANES + 4 * MOST_PLANES;

    private final double[] at = new double[MOST_COPIES * MOST_PARTS * STRIDE];
    private final int[] planes = new int[MOST_COPIES * MOST_PARTS];
    private final boolean[] shown = new boolean[MOST_COPIES * MOST_PARTS];
    private final int[] cameThrough = new int[MOST_COPIES];
    private final Vector3d centre = new Vector3d();
    private final Vector3d anchor = new Vector3d();
    private final Vector3d deepest = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private int copies;
    private int parts;

    /** Begins an object: {@link #place} its parts, then {@link #makeCopies}. */
    void begin(int partCount) {
        parts = partCount;
        copies = 1;
        cameThrough[0] = Portals.CLOSED;
    }

    /**
     * Sets the pose of a part.
     *
     * @param dynamicObjectAnchor a point of the object that decides on which side of portals it is
     */
    void place(int part, Vector3d partCentre, Quaterniond worldFromPart, Vector3d dynamicObjectAnchor) {
        write(part, partCentre, worldFromPart, dynamicObjectAnchor);
        planes[part] = 0;
        shown[part] = true;
    }

    private void write(int slot, Vector3d partCentre, Quaterniond worldFromPart, Vector3d partAnchor) {
        int i = slot * STRIDE;
        at[i] = worldFromPart.x;
        at[i + 1] = worldFromPart.y;
        at[i + 2] = worldFromPart.z;
        at[i + 3] = worldFromPart.w;
        at[i + CENTRE] = partCentre.x;
        at[i + CENTRE + 1] = partCentre.y;
        at[i + CENTRE + 2] = partCentre.z;
        at[i + ANCHOR] = partAnchor.x;
        at[i + ANCHOR + 1] = partAnchor.y;
        at[i + ANCHOR + 2] = partAnchor.z;
    }

    /** Makes the copies. */
    void makeCopies(Portals portals, DynamicShape[] shapes) {
        for (int copy = 0; copy < copies; copy++) {
            for (int portal = 0; portal < portals.size(); portal++) {
                if (portals.isOpen(portal) && portal != cameThrough[copy]) {
                    reach(copy, portal, portals, shapes);
                }
            }
        }
    }

    private void reach(int copy, int portal, Portals portals, DynamicShape[] shapes) {
        Portal entry = portals.portal(portal);
        int image = -1;
        for (int part = 0; part < parts; part++) {
            int slot = copy * MOST_PARTS + part;
            if (!shown[slot] || planes[slot] == MOST_PLANES || !reaches(slot, entry, shapes[part])) {
                continue;
            }
            if (image < 0) {
                image = copies == MOST_COPIES ? -1 : image(portals.partner(portal));
                if (image < 0) {
                    return;
                }
            }
            cut(slot, entry);
            pass(image * MOST_PARTS + part, portals.transform(portal), portals.portal(portals.partner(portal)));
        }
    }

    private int image(int exit) {
        for (int part = 0; part < parts; part++) {
            shown[copies * MOST_PARTS + part] = false;
        }
        cameThrough[copies] = exit;
        return copies++;
    }

    /**
     * Returns true if a part reaches through a portal. Stores the part's pose in {@link #centre} and {@link #turn}, and
     * its intersection with the plane in {@link #anchor}.
     */
    private boolean reaches(int slot, Portal portal, DynamicShape shape) {
        centre(slot, centre);
        double before = portal.inFront(centre.x, centre.y, centre.z);
        if (Math.abs(before) > 2 * shape.reachMetres() + 3 || before > shape.reachMetres()) {
            return false;
        }
        int i = slot * STRIDE + ANCHOR;
        anchor.set(at[i], at[i + 1], at[i + 2]);
        double anchored = portal.inFront(anchor.x, anchor.y, anchor.z);
        if (anchored < 0) {
            return false;
        }
        orientation(slot, turn);
        shape.support(portal.frame().back(), turn, deepest);
        deepest.negate().add(centre);
        double depth = portal.inFront(deepest.x, deepest.y, deepest.z);
        if (depth > -SLACK_METRES) {
            return false;
        }
        anchor.lerp(deepest, anchored / (anchored - depth));
        return portal.aperture()
                .contains(portal.across(anchor.x, anchor.y, anchor.z), portal.upward(anchor.x, anchor.y, anchor.z));
    }

    private void cut(int slot, Portal portal) {
        int i = slot * STRIDE + PLANES + 4 * planes[slot]++;
        at[i] = portal.normal().x();
        at[i + 1] = portal.normal().y();
        at[i + 2] = portal.normal().z();
        at[i + 3] = portal.inFront(centre.x, centre.y, centre.z);
    }

    private void pass(int slot, PortalTransform transform, Portal exit) {
        transform.point(centre);
        transform.point(anchor);
        transform.orientation(turn);
        write(slot, centre, turn, anchor);
        planes[slot] = 0;
        shown[slot] = true;
        cut(slot, exit);
    }

    int copies() {
        return copies;
    }

    static int slot(int copy, int part) {
        return copy * MOST_PARTS + part;
    }

    /** Returns true if any of the part may be visible there. */
    boolean isShown(int slot) {
        return shown[slot];
    }

    Vector3d centre(int slot, Vector3d out) {
        int i = slot * STRIDE + CENTRE;
        return out.set(at[i], at[i + 1], at[i + 2]);
    }

    Quaterniond orientation(int slot, Quaterniond out) {
        int i = slot * STRIDE;
        return out.set(at[i], at[i + 1], at[i + 2], at[i + 3]);
    }

    /**
     * Computes a position in front of the first portal that the copy reaches through: the anchor of its first shown
     * part, moved away from the portal's plane by {@link #OFF_METRES}.
     */
    Vector3d openPlace(int copy, Vector3d out) {
        int part = 0;
        while (part + 1 < parts && !shown[slot(copy, part)]) {
            part++;
        }
        int i = slot(copy, part) * STRIDE + ANCHOR;
        out.set(at[i], at[i + 1], at[i + 2]);
        if (planes[slot(copy, part)] > 0) {
            int plane = slot(copy, part) * STRIDE + PLANES;
            out.add(OFF_METRES * at[plane], OFF_METRES * at[plane + 1], OFF_METRES * at[plane + 2]);
        }
        return out;
    }

    int planes(int slot) {
        return planes[slot];
    }

    /** Returns component 0–2 of a clip plane's normal, or 3 for the signed distance of the part's centre, metres. */
    double plane(int slot, int plane, int component) {
        return at[slot * STRIDE + PLANES + 4 * plane + component];
    }
}
