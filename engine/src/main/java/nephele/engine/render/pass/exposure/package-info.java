/** Exposure that follows from the picture: a histogram of its luminance on the GPU, and adaption to it. */
package nephele.engine.render.pass.exposure;
