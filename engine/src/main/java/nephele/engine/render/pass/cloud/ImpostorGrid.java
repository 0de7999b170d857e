package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.PuffSlabs;

/** The rays of the picture of a slab. */
record ImpostorGrid(PuffSlabs slabs, PuffSlabs.Slab slab) implements RayGrid {
    @Override
    public void put(PixelUniforms.Rays rays) {
        rays.square().set(1, 0, 0);
        rays.step().set((float) (2.0 / slabs.raster().width()), (float)
                (2.0 / slabs.raster().height()));
        rays.plane().set((float) slab.middle());
    }

    @Override
    public double pixel() {
        return 2.0 / slabs.raster().height();
    }

    @Override
    public double secondsBefore() {
        throw new UnsupportedOperationException("a picture has no history");
    }
}
