package nephele.engine.collision.rigid.contact;

import nephele.engine.collision.rigid.body.Poses;

/**
 * Contact of two boxes: the fifteen axes of Gottschalk, Lin and Manocha (1996), in the frame of the first as in
 * Ericson, Real-Time Collision Detection (2005), section 4.4.1; then the face of one clipped by the other, or the
 * nearest points of two edges. Reused.
 */
final class BoxBoxContact {
    private final FaceClip clip;
    private final double[] dots = new double[9];
    private final double[] size = new double[9];
    /** Separation along the three axes of each box. */
    private final double[] gap = new double[6];
    /** Signed distance of the centres along them, from the first to the second. */
    private final double[] along = new double[6];

    private Poses poses;
    private int a;
    private int b;
    private double dX;
    private double dY;
    private double dZ;
    private double edgeGap;
    private int edge;
    private final BoxEdge onFirst = new BoxEdge();
    private final BoxEdge onSecond = new BoxEdge();
    /** Distance of the crossing from the middle of the second box's edge, metres. */
    private double onSecondEdge;

    private double tolerance;

    BoxBoxContact(FaceClip clip) {
        this.clip = clip;
    }

    /** Fills {@code out} with the points nearer than {@code reach}. */
    void touch(Poses where, int first, int second, double reach, Manifold out) {
        poses = where;
        a = first;
        b = second;
        double[] c = poses.centre;
        dX = c[3 * b] - c[3 * a];
        dY = c[3 * b + 1] - c[3 * a + 1];
        dZ = c[3 * b + 2] - c[3 * a + 2];
        out.clear();
        if (!facesWithin(reach)) {
            return;
        }
        double least = Math.min(poses.leastHalf(a), poses.leastHalf(b));
        tolerance = FaceClip.tolerance(least);
        int face = bestFace();
        if (!edgesWithin(reach)) {
            return;
        }
        if (edgeGap > gap[face] + FaceClip.edgeMargin(least)) {
            edgePoints(reach, out);
            return;
        }
        double leastGap = gap[face] - poses.leastHalf(a) / 2;
        for (int attempt = 0; attempt < 3 && gap[face] > leastGap; attempt++) {
            if (facePoints(face, reach, out)) {
                return;
            }
            gap[face] = Double.NEGATIVE_INFINITY;
            face = bestFace();
        }
    }

    private boolean facesWithin(double reach) {
        double[] x = poses.axes;
        double[] h = poses.half;
        for (int i = 0; i < 3; i++) {
            int p = Poses.AXES * a + 3 * i;
            for (int j = 0; j < 3; j++) {
                int q = Poses.AXES * b + 3 * j;
                double dot = x[p] * x[q] + x[p + 1] * x[q + 1] + x[p + 2] * x[q + 2];
                dots[3 * i + j] = dot;
                size[3 * i + j] = Math.abs(dot);
            }
            along[i] = x[p] * dX + x[p + 1] * dY + x[p + 2] * dZ;
            gap[i] = Math.abs(along[i])
                    - h[3 * a + i]
                    - h[3 * b] * size[3 * i]
                    - h[3 * b + 1] * size[3 * i + 1]
                    - h[3 * b + 2] * size[3 * i + 2];
            if (gap[i] > reach) {
                return false;
            }
        }
        for (int j = 0; j < 3; j++) {
            int q = Poses.AXES * b + 3 * j;
            along[3 + j] = x[q] * dX + x[q + 1] * dY + x[q + 2] * dZ;
            gap[3 + j] = Math.abs(along[3 + j])
                    - h[3 * b + j]
                    - h[3 * a] * size[j]
                    - h[3 * a + 1] * size[3 + j]
                    - h[3 * a + 2] * size[6 + j];
            if (gap[3 + j] > reach) {
                return false;
            }
        }
        return true;
    }

    /** Prefers the first box's faces to nearly equal ones, so that the choice is stable between ticks. */
    private int bestFace() {
        int best = 0;
        for (int i = 1; i < 6; i++) {
            best = gap[i] > gap[best] + (i < 3 ? tolerance / 8 : tolerance) ? i : best;
        }
        return best;
    }

    private boolean edgesWithin(double reach) {
        edgeGap = Double.NEGATIVE_INFINITY;
        double[] h = poses.half;
        for (int i = 0; i < 3; i++) {
            int i1 = (i + 1) % 3;
            int i2 = (i + 2) % 3;
            for (int j = 0; j < 3; j++) {
                double square = 1 - dots[3 * i + j] * dots[3 * i + j];
                if (square < FaceClip.PARALLEL_SINE_SQUARED) {
                    continue;
                }
                int j1 = (j + 1) % 3;
                int j2 = (j + 2) % 3;
                double length = Math.sqrt(square);
                double distance = Math.abs(along[i2] * dots[3 * i1 + j] - along[i1] * dots[3 * i2 + j]);
                double ra = h[3 * a + i1] * size[3 * i2 + j] + h[3 * a + i2] * size[3 * i1 + j];
                double rb = h[3 * b + j1] * size[3 * i + j2] + h[3 * b + j2] * size[3 * i + j1];
                double separation = (distance - ra - rb) / length;
                if (separation > reach) {
                    return false;
                }
                if (separation > edgeGap + tolerance / 8) {
                    edgeGap = separation;
                    edge = 3 * i + j;
                }
            }
        }
        return true;
    }

    /** Returns false when the faces do not overlap along the axis: then this axis gives no contact. */
    private boolean facePoints(int face, double reach, Manifold out) {
        boolean ofFirst = face < 3;
        int i = ofFirst ? face : face - 3;
        int reference = ofFirst ? a : b;
        int incident = ofFirst ? b : a;
        double[] x = poses.axes;
        double[] h = poses.half;
        // From the reference box to the other one.
        double sign = (along[face] < 0) == ofFirst ? -1 : 1;
        int r = Poses.AXES * reference + 3 * i;
        double nX = sign * x[r];
        double nY = sign * x[r + 1];
        double nZ = sign * x[r + 2];
        addIncidentFace(incident, i, ofFirst, nX, nY, nZ);
        double rX = ofFirst ? 0 : dX;
        double rY = ofFirst ? 0 : dY;
        double rZ = ofFirst ? 0 : dZ;
        for (int k = 1; k < 3; k++) {
            int axis = (i + k) % 3;
            int s = Poses.AXES * reference + 3 * axis;
            double centre = rX * x[s] + rY * x[s + 1] + rZ * x[s + 2];
            clip.side(x[s], x[s + 1], x[s + 2], centre + h[3 * reference + axis], 2 * k);
            clip.side(-x[s], -x[s + 1], -x[s + 2], h[3 * reference + axis] - centre, 2 * k + 1);
        }
        if (clip.isSliver()) {
            return false;
        }
        out.code = face + (sign > 0 ? 6 : 0);
        double turn = ofFirst ? -1 : 1;
        out.normal(turn * nX, turn * nY, turn * nZ);
        double distance = rX * nX + rY * nY + rZ * nZ + h[3 * reference + i];
        clip.keep(nX, nY, nZ, distance, reach, out);
        return true;
    }

    private void addIncidentFace(int incident, int referenceAxis, boolean ofFirst, double nX, double nY, double nZ) {
        double[] x = poses.axes;
        double[] h = poses.half;
        int j = 0;
        for (int k = 1; k < 3; k++) {
            double now = ofFirst ? size[3 * referenceAxis + k] : size[3 * k + referenceAxis];
            double best = ofFirst ? size[3 * referenceAxis + j] : size[3 * j + referenceAxis];
            j = now > best + 1e-9 ? k : j;
        }
        int q = Poses.AXES * incident + 3 * j;
        double sign = x[q] * nX + x[q + 1] * nY + x[q + 2] * nZ > 0 ? -1 : 1;
        double reach = sign * h[3 * incident + j];
        double cX = (ofFirst ? dX : 0) + reach * x[q];
        double cY = (ofFirst ? dY : 0) + reach * x[q + 1];
        double cZ = (ofFirst ? dZ : 0) + reach * x[q + 2];
        int u = Poses.AXES * incident + 3 * ((j + 1) % 3);
        int v = Poses.AXES * incident + 3 * ((j + 2) % 3);
        double hu = h[3 * incident + (j + 1) % 3];
        double hv = h[3 * incident + (j + 2) % 3];
        clip.start(tolerance);
        int id = sign > 0 ? 0 : 4;
        for (int k = 0; k < 4; k++) {
            double su = k == 0 || k == 3 ? hu : -hu;
            double sv = k < 2 ? hv : -hv;
            clip.corner(
                    cX + su * x[u] + sv * x[v],
                    cY + su * x[u + 1] + sv * x[v + 1],
                    cZ + su * x[u + 2] + sv * x[v + 2],
                    id + k);
        }
    }

    /**
     * Adds the crossings of the deepest edges, and those of their parallel neighbours if these are near too: crossed
     * narrow faces then get all corners of their overlap as contact points.
     */
    private void edgePoints(double reach, Manifold out) {
        int i = edge / 3;
        int j = edge % 3;
        double[] x = poses.axes;
        int p = Poses.AXES * a + 3 * i;
        int q = Poses.AXES * b + 3 * j;
        double nX = x[p + 1] * x[q + 2] - x[p + 2] * x[q + 1];
        double nY = x[p + 2] * x[q] - x[p] * x[q + 2];
        double nZ = x[p] * x[q + 1] - x[p + 1] * x[q];
        double length = Math.sqrt(nX * nX + nY * nY + nZ * nZ);
        // From the first box to the second.
        length = nX * dX + nY * dY + nZ * dZ < 0 ? -length : length;
        out.normal(-nX / length, -nY / length, -nZ / length);
        out.code = 12 + edge;
        onFirst.take(poses, a, i, out, -1);
        onSecond.take(poses, b, j, out, 1);
        for (int k = 0; k < 4; k++) {
            double gap = edgeGap + (k % 2 == 0 ? 0 : onFirst.rise) + (k < 2 ? 0 : onSecond.rise);
            double s = crossing(k);
            if (k == 0) {
                double limit = poses.half[3 * a + i];
                addCrossing(0, Math.max(-limit, Math.min(limit, s)), gap, out);
            } else if (gap < reach && isOnBoth(s)) {
                addCrossing(k, s, gap, out);
            }
        }
    }

    /**
     * Returns the position on the first box's edge, from its middle, at which the second's crosses it; sets that on the
     * second's.
     *
     * @param which 1 for the other edge of the first, 2 of the second, 3 of both
     */
    private double crossing(int which) {
        double dot = dots[edge];
        double wa = 0;
        double wb = 0;
        for (int c = 0; c < 3; c++) {
            double to = c == 0 ? dX : c == 1 ? dY : dZ;
            double w = to + onSecond.middle(which >= 2, c) - onFirst.middle(which % 2 == 1, c);
            wa += w * onFirst.along(c);
            wb += w * onSecond.along(c);
        }
        double s = (wa - dot * wb) / (1 - dot * dot);
        onSecondEdge = dot * s - wb;
        return s;
    }

    private boolean isOnBoth(double s) {
        return Math.abs(s) < poses.half[3 * a + edge / 3] && Math.abs(onSecondEdge) < poses.half[3 * b + edge % 3];
    }

    private void addCrossing(int which, double s, double gap, Manifold out) {
        double half = gap / 2;
        boolean other = which % 2 == 1;
        out.add(
                onFirst.middle(other, 0) + s * onFirst.along(0) - half * out.nX,
                onFirst.middle(other, 1) + s * onFirst.along(1) - half * out.nY,
                onFirst.middle(other, 2) + s * onFirst.along(2) - half * out.nZ,
                gap,
                onFirst.side(other) + 4 * onSecond.side(which >= 2));
    }

    /** The edge of a box farthest along a normal, and the adjacent parallel edge that is next farthest. Reused. */
    private static final class BoxEdge {
        private final double[] axis = new double[3];
        private final double[] nearest = new double[3];
        private final double[] next = new double[3];
        private int nearestSide;
        private int nextSide;

        /** Distance in metres by which the other edge is farther back along the normal. */
        double rise;

        /**
         * Finds both edges.
         *
         * @param sign 1 if the manifold's normal points out of the box, −1 if into it
         */
        void take(Poses poses, int box, int ofAxis, Manifold manifold, double sign) {
            double[] x = poses.axes;
            double least = Double.POSITIVE_INFINITY;
            int flipped = 0;
            nearestSide = 0;
            for (int c = 0; c < 3; c++) {
                axis[c] = x[Poses.AXES * box + 3 * ofAxis + c];
                nearest[c] = 0;
            }
            for (int k = 1; k < 3; k++) {
                int at = Poses.AXES * box + 3 * ((ofAxis + k) % 3);
                double h = poses.half[3 * box + (ofAxis + k) % 3];
                double dot = sign * (x[at] * manifold.nX + x[at + 1] * manifold.nY + x[at + 2] * manifold.nZ);
                double side = dot < 0 ? -h : h;
                nearestSide += dot < 0 ? 0 : k;
                for (int c = 0; c < 3; c++) {
                    nearest[c] += side * x[at + c];
                }
                if (2 * h * Math.abs(dot) < least) {
                    least = 2 * h * Math.abs(dot);
                    flipped = dot < 0 ? k : -k;
                    for (int c = 0; c < 3; c++) {
                        next[c] = -2 * side * x[at + c];
                    }
                }
            }
            rise = least;
            nextSide = nearestSide + flipped;
            for (int c = 0; c < 3; c++) {
                next[c] += nearest[c];
            }
        }

        double along(int component) {
            return axis[component];
        }

        /** Returns the middle of the nearest or the other edge, relative to the box's centre. */
        double middle(boolean other, int component) {
            return other ? next[component] : nearest[component];
        }

        /** Returns the number, 0 to 3, of the edge among the four parallel ones. */
        int side(boolean other) {
            return other ? nextSide : nearestSide;
        }
    }
}
