package nephele.workshop.prove.edits;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.scene.Opening;
import nephele.engine.scene.Scene;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.SolidGeometry;
import nephele.engine.scene.light.PunctualLightTable;

/** The bitwise differences between an edited level and the same level freshly loaded. */
final class Differences {
    private static final int QUERIES = 50;

    private final List<String> found = new ArrayList<>();

    private Differences() {}

    /** Returns the names of the parts that differ; empty if all are the same. */
    static List<String> of(EditedTown edited, EditedTown fresh) {
        Differences differences = new Differences();
        differences.scene(edited.scene(), fresh.scene());
        differences.collision(edited.simulated().statics(), fresh.simulated().statics());
        differences.lights(edited.scene().lights(), fresh.scene().lights());
        return differences.found;
    }

    private void expect(boolean isSame, String part) {
        if (!isSame) {
            found.add(part);
        }
    }

    private void scene(Scene edited, Scene fresh) {
        expect(edited.statics().solids().equals(fresh.statics().solids()), "brushes");
        expect(edited.light() == fresh.light(), "light of the sky");
        materials(edited.materials(), fresh.materials());
        geometry(edited.solids(), fresh.solids());
        expect(described(edited.mirrors()).equals(described(fresh.mirrors())), "mirrors");
    }

    private static List<String> described(List<Opening> mirrors) {
        return mirrors.stream()
                .map(mirror -> mirror.centre() + " " + mirror.frame() + mirror.tint() + mirror.reach(1, 0.3))
                .toList();
    }

    private void materials(SceneMaterials edited, SceneMaterials fresh) {
        expect(edited.surfaces().equals(fresh.surfaces()) && edited.indexById().equals(fresh.indexById()), "surfaces");
        expect(isSame(edited.colourArrays(), fresh.colourArrays()), "pictures");
        expect(isSame(edited.normalArrays(), fresh.normalArrays()), "normal maps");
    }

    private static boolean isSame(List<SceneMaterials.PictureArray> some, List<SceneMaterials.PictureArray> others) {
        boolean isSame = some.size() == others.size();
        for (int i = 0; i < some.size() && isSame; i++) {
            isSame = some.get(i).width() == others.get(i).width()
                    && some.get(i).layers().size() == others.get(i).layers().size();
        }
        return isSame;
    }

    private void geometry(SolidGeometry edited, SolidGeometry fresh) {
        expect(isSame(edited.solids(), fresh.solids()), "triangles of solids");
        expect(isSame(edited.models(), fresh.models()), "triangles of models");
        expect(edited.origin().equals(fresh.origin()) && edited.slotCount() == fresh.slotCount(), "origin or slots");
        boolean areSame = edited.batches().size() == fresh.batches().size();
        for (int i = 0; i < edited.batches().size() && areSame; i++) {
            areSame = isSame(edited.batches().get(i), fresh.batches().get(i));
        }
        expect(areSame, "batches");
    }

    private static boolean isSame(SolidGeometry.Triangles some, SolidGeometry.Triangles others) {
        return some.vertices().equals(others.vertices()) && some.indices().equals(others.indices());
    }

    private static boolean isSame(SolidBatch some, SolidBatch other) {
        return some.form() == other.form()
                && some.kind().equals(other.kind())
                && some.cellOrigin().equals(other.cellOrigin())
                && some.firstIndex() == other.firstIndex()
                && Arrays.equals(some.indexEnds(), other.indexEnds());
    }

    private void lights(PunctualLightTable edited, PunctualLightTable fresh) {
        expect(Arrays.equals(edited.packed(Vec3.ZERO), fresh.packed(Vec3.ZERO)), "punctual lights");
        expect(Arrays.equals(edited.packedGrid(), fresh.packedGrid()), "cells of lights");
    }

    private void collision(CollisionWorld edited, CollisionWorld fresh) {
        boolean isSame = edited.size() == fresh.size() && edited.extent().equals(fresh.extent());
        for (int i = 0; i < fresh.size() && isSame; i++) {
            isSame = isSame(edited.collider(i), fresh.collider(i));
        }
        expect(isSame, "colliders");
        queries(edited, fresh);
    }

    private static boolean isSame(Collider some, Collider other) {
        return some.solidId().equals(other.solidId())
                && some.centre().equals(other.centre())
                && some.shape().equals(other.shape());
    }

    private void queries(CollisionWorld edited, CollisionWorld fresh) {
        SplittableRandom random = new SplittableRandom(fresh.size());
        Aabb all = fresh.extent();
        RayCast some = new RayCast();
        RayCast others = new RayCast();
        ItemList near = new ItemList();
        ItemList nearToo = new ItemList();
        boolean isSame = true;
        for (int i = 0; i < QUERIES; i++) {
            Vec3 from = within(all, random);
            Vec3 to = within(all, random);
            Ray ray = new Ray(from.x(), from.y(), from.z(), to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
            isSame &= some.cast(edited, ray, 1) == others.cast(fresh, ray, 1)
                    && some.collider() == others.collider()
                    && some.distance() == others.distance();
            Aabb box = Aabb.around(from, new Vec3(2, 2, 2));
            edited.overlapping(box, near);
            fresh.overlapping(box, nearToo);
            isSame &= Arrays.equals(near.toArray(), nearToo.toArray());
        }
        expect(isSame, "rays or overlaps");
    }

    private static Vec3 within(Aabb box, SplittableRandom random) {
        return new Vec3(
                box.minX() + random.nextDouble() * (box.maxX() - box.minX()),
                box.minY() + random.nextDouble() * (box.maxY() - box.minY()),
                box.minZ() + random.nextDouble() * (box.maxZ() - box.minZ()));
    }
}
