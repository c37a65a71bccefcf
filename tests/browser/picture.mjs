// Makes the picture of the README: the report of a terrain of the tests, with its flow paths.
//
//     tests/browser/run.sh build               first: it fetches what is needed
//     tests/browser/picture.sh build
import {close, kData, open, settle, start, stop, thalweg, work} from './support.mjs';

await start();
thalweg('build', `${kData}jacksboro_1.xyz`, '--report', 'picture.html');
const report = await open('picture.html', {width: 1320, height: 900});
await report.page.locator('#layer-flow').click();
await settle(report.page);
await report.page.screenshot({path: work('picture.png')});
await close(report);
await stop();
