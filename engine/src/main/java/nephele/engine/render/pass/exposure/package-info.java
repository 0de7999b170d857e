/** Exposure that follows from the picture: a histogram of its luminance on the GPU, and adaption to what it calls for. */
package nephele.engine.render.pass.exposure;
